// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/FoldedShapes.h"

#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"

#include <array>
#include <cmath>
#include <random>

namespace evolving::shapes
{

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// The first one from a number on.
Index faceTowards(const SurfaceMesh& mesh, const Vec3& normal, Index face)
{
  while (faceVectorArea(mesh, face).normalized().dot(normal) < 0.9)
  {
    ++face;
  }
  return face;
}

} // namespace

SurfaceMesh starCones(double unevenness)
{
  SurfaceMesh mesh;
  const Index top = mesh.addPoint(Vec3(0.02, 0.01, 1));
  const Index bottom = mesh.addPoint(Vec3(-0.01, 0.03, -1));
  for (int k = 0; k < 5; ++k)
  {
    const double angle = 4.0 * Pi * k / 5.0;
    mesh.addPoint(Vec3(std::cos(angle), std::sin(angle), unevenness * (k % 3 - 0.7 * (k % 2))));
  }
  for (Index k = 0; k < 5; ++k)
  {
    const Index a = 2 + k;
    const Index b = 2 + (k + 1) % 5;
    mesh.addFace({ top, a, b });
    mesh.addFace({ bottom, b, a });
  }
  return mesh;
}

SurfaceMesh boxesOfOnePart()
{
  const SurfaceMesh boxes = merged(box(-Vec3::Ones(), Vec3::Ones()),
    transformed(triangleBox(4, 1.1 * Vec3::Ones()), 1.0, 1.1 * Vec3::Ones()));
  const Index begin = faceTowards(boxes, -Vec3::UnitX(), 0);
  const Index end = faceTowards(boxes, Vec3::UnitX(), 12);
  SurfaceMesh mesh = without(boxes, [&](Index face) { return face == begin || face == end; });
  std::array<Index, 3> section = { boxes.faceVertex(begin, 0), boxes.faceVertex(begin, 1),
    boxes.faceVertex(begin, 2) };
  const std::array<Index, 3> last = { boxes.faceVertex(end, 1), boxes.faceVertex(end, 0),
    boxes.faceVertex(end, 2) };
  const auto lead = [&](const std::array<Index, 3>& next)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t l = (k + 1) % 3;
      mesh.addFace({ section[k], section[l], next[l] });
      mesh.addFace({ section[k], next[l], next[k] });
    }
    section = next;
  };
  const auto moved = [&](const std::array<Index, 3>& triangle, const Vec3& by)
  {
    return std::array<Index, 3>{ mesh.addPoint(boxes.points[at(triangle[0])] + by),
      mesh.addPoint(boxes.points[at(triangle[1])] + by),
      mesh.addPoint(boxes.points[at(triangle[2])] + by) };
  };
  const std::array<Index, 3> first = section;
  lead(moved(first, Vec3(-0.7, 0.01, 0.02)));
  lead(moved(first, Vec3(-0.8, 0.03, 4)));
  lead(moved(last, Vec3(0.9, 0.04, 4.1)));
  lead(moved(last, Vec3(0.7, 0.02, 0.01)));
  lead(last);
  return mesh;
}

SurfaceMesh umbrella(int count, unsigned seed)
{
  std::mt19937 generator(seed);
  SurfaceMesh mesh;
  mesh.addPoint(Vec3(0.1, 0.2, 0.3));
  for (int i = 0; i < count; ++i)
  {
    const Index a = mesh.addPoint(randomPoint(generator));
    const Index b = mesh.addPoint(randomPoint(generator));
    mesh.addFace({ 0, a, b });
  }
  return mesh;
}

} // namespace evolving::shapes
