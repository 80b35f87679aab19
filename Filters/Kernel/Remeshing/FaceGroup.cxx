// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/FaceGroup.h"

#include "Remeshing/FaceShape.h"

#include <algorithm>
#include <functional>

namespace evolving
{

namespace
{

/// No face may turn by more than 45 degrees.
constexpr double LeastCosine = 0.7;

} // namespace

Triangle triangleOf(const EditableSurface& surface, Index f)
{
  return { { surface.corner(f, 0), surface.corner(f, 1), surface.corner(f, 2) } };
}

std::vector<Vec3> areasOf(const EditableSurface& surface, const std::vector<Index>& faces)
{
  std::vector<Vec3> areas;
  for (const Index f : faces)
  {
    areas.push_back(surface.doubleArea(f));
  }
  return areas;
}

bool areUpright(
  const EditableSurface& surface, const std::vector<Index>& faces, const std::vector<Vec3>& before)
{
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const Vec3 area = surface.doubleArea(faces[i]);
    if (area.dot(before[i]) < LeastCosine * area.norm() * before[i].norm())
    {
      return false;
    }
  }
  return true;
}

std::size_t fingerprintOf(const EditableSurface& surface, const std::vector<Index>& faces)
{
  std::size_t print = 0;
  for (const Index f : faces)
  {
    for (Index k = 0; k < 3; ++k)
    {
      for (const double coordinate : surface.corner(f, k))
      {
        print = 31 * print + std::hash<double>()(coordinate);
      }
    }
  }
  return print;
}

double smallestAngleOf(const EditableSurface& surface, const std::vector<Index>& faces)
{
  double smallest = 60.0;
  for (const Index f : faces)
  {
    smallest = std::min(smallest, smallestAngle(surface, f));
  }
  return smallest;
}

} // namespace evolving
