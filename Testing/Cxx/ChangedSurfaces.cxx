// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ChangedSurfaces.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace Sample
{

//------------------------------------------------------------------------------
Surface Soup(vtkPolyData* surface)
{
  const std::vector<Point> shared = CoordinatesOf(surface);
  std::vector<Point> points;
  std::vector<Polygon> polygons = PolygonsOf(surface);
  for (Polygon& polygon : polygons)
  {
    for (vtkIdType& id : polygon)
    {
      points.push_back(shared[static_cast<std::size_t>(id)]);
      id = static_cast<vtkIdType>(points.size()) - 1;
    }
  }
  return Make(points, polygons);
}

//------------------------------------------------------------------------------
Surface Triangulated(vtkPolyData* surface)
{
  std::vector<Polygon> triangles;
  for (const Polygon& polygon : PolygonsOf(surface))
  {
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
    {
      triangles.push_back({ polygon[0], polygon[k], polygon[k + 1] });
    }
  }
  return Make(CoordinatesOf(surface), triangles);
}

//------------------------------------------------------------------------------
Surface PointsOf(vtkPolyData* surface)
{
  return Make(CoordinatesOf(surface), {});
}

//------------------------------------------------------------------------------
Surface Together(vtkPolyData* a, vtkPolyData* b)
{
  std::vector<Point> points = CoordinatesOf(a);
  std::vector<Polygon> polygons = PolygonsOf(a);
  const auto offset = static_cast<vtkIdType>(points.size());
  for (Polygon polygon : PolygonsOf(b))
  {
    std::for_each(polygon.begin(), polygon.end(), [offset](vtkIdType& id) { id += offset; });
    polygons.push_back(polygon);
  }
  const std::vector<Point> others = CoordinatesOf(b);
  points.insert(points.end(), others.begin(), others.end());
  return Make(points, polygons);
}

//------------------------------------------------------------------------------
Surface KeepPolygons(vtkPolyData* surface, bool (*kept)(vtkIdType number))
{
  std::vector<Polygon> polygons;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    if (kept(i))
    {
      polygons.push_back(PolygonOf(surface, i));
    }
  }
  return Make(CoordinatesOf(surface), polygons);
}

//------------------------------------------------------------------------------
Surface Mapped(vtkPolyData* surface, Point (*map)(const Point& point))
{
  std::vector<Point> points = CoordinatesOf(surface);
  std::transform(points.begin(), points.end(), points.begin(), map);
  return Make(points, PolygonsOf(surface));
}

//------------------------------------------------------------------------------
Surface InsideOut(vtkPolyData* surface)
{
  std::vector<Polygon> polygons = PolygonsOf(surface);
  for (Polygon& polygon : polygons)
  {
    std::reverse(polygon.begin(), polygon.end());
  }
  return Make(CoordinatesOf(surface), polygons);
}

//------------------------------------------------------------------------------
Surface WithMixedOrientation(vtkPolyData* surface)
{
  std::vector<Polygon> polygons = PolygonsOf(surface);
  for (std::size_t i = 0; i < polygons.size(); i += 2)
  {
    std::reverse(polygons[i].begin(), polygons[i].end());
  }
  return Make(CoordinatesOf(surface), polygons);
}

//------------------------------------------------------------------------------
Point TowardsThePole(const Point& p)
{
  const double angle = std::acos(std::clamp(p[2], -1.0, 1.0));
  const double drawn = angle - 0.4 * std::sin(angle);
  const double around = std::atan2(p[1], p[0]);
  return { std::sin(drawn) * std::cos(around), std::sin(drawn) * std::sin(around),
    std::cos(drawn) };
}

//------------------------------------------------------------------------------
Point TowardsACorner(const Point& p)
{
  const auto draw = [](double x) { return x + 0.3 * (1.0 - x * x); };
  return { draw(p[0]), draw(p[1]), draw(p[2]) };
}

} // namespace Sample
