// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SelfCrossingSurfaces.h"

#include "vtkMath.h"
#include "vtkPolyData.h"

#include <array>
#include <cmath>
#include <vector>

namespace
{

using Sample::Point;
using Sample::Polygon;

//------------------------------------------------------------------------------
/// The walls over a closed line, |z| <= 1/2, and caps that are fans about a point.
Sample::Surface Prism(
  const std::vector<std::array<double, 2>>& line, const std::array<double, 2>& apex)
{
  std::vector<Point> points;
  for (const double z : { -0.5, 0.5 })
  {
    for (const auto& p : line)
    {
      points.push_back({ p[0], p[1], z });
    }
    points.push_back({ apex[0], apex[1], z });
  }
  const auto n = static_cast<vtkIdType>(line.size());
  const vtkIdType top = n + 1;
  std::vector<Polygon> polygons;
  for (vtkIdType i = 0; i < n; ++i)
  {
    const vtkIdType next = (i + 1) % n;
    polygons.push_back({ i, next, top + next, top + i });
    polygons.push_back({ n, next, i });
    polygons.push_back({ top + n, top + i, top + next });
  }
  return Sample::Make(points, polygons);
}

} // namespace

//------------------------------------------------------------------------------
Sample::Surface Sample::SelfOverlappingPrism()
{
  constexpr int Count = 60;
  std::vector<std::array<double, 2>> line;
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / Count;
    const double r = 0.5 + std::cos(angle);
    line.push_back({ r * std::cos(angle), r * std::sin(angle) });
  }
  return Prism(line, { 0.25, 0.0 });
}

//------------------------------------------------------------------------------
Sample::Surface Sample::TwistedPrism()
{
  return Prism({ { -1, 1 }, { -1, -1 }, { 0.6, 0.6 }, { 0.6, -0.6 } }, { 0, 0 });
}

//------------------------------------------------------------------------------
Sample::Surface Sample::KleinBottle(int around, int across)
{
  std::vector<Point> points;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2.0 * vtkMath::Pi() * i / around;
      const double v = 2.0 * vtkMath::Pi() * (j + 0.5) / across;
      const double a = 0.4 * std::sin(v);
      const double b = 0.4 * std::sin(2.0 * v);
      const double r = 1.0 + std::cos(u / 2) * a - std::sin(u / 2) * b;
      points.push_back(
        { r * std::cos(u), r * std::sin(u), std::sin(u / 2) * a + std::cos(u / 2) * b });
    }
  }
  // After a full turn v has become -v.
  const auto number = [=](int i, int j) -> vtkIdType
  {
    const int wrapped = j % across;
    return i < around ? i * across + wrapped : across - 1 - wrapped;
  };
  std::vector<Polygon> polygons;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      polygons.push_back(
        { number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1) });
    }
  }
  return Make(points, polygons);
}
