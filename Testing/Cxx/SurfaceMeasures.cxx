// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceMeasures.h"

#include "ChangedSurfaces.h"

#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace
{

using Sample::Point;
using Sample::Polygon;

//------------------------------------------------------------------------------
Point Minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

//------------------------------------------------------------------------------
Point Cross(const Point& a, const Point& b)
{
  Point c;
  vtkMath::Cross(a.data(), b.data(), c.data());
  return c;
}

//------------------------------------------------------------------------------
/// Sums over the triangles of all polygons, cut as fans.
double SumOverTriangles(
  vtkPolyData* surface, double (*value)(const Point& a, const Point& b, const Point& c))
{
  const std::vector<Point> points = Sample::CoordinatesOf(surface);
  double sum = 0.0;
  for (const Polygon& polygon : Sample::PolygonsOf(Sample::Triangulated(surface)))
  {
    sum += value(points[static_cast<std::size_t>(polygon[0])],
      points[static_cast<std::size_t>(polygon[1])], points[static_cast<std::size_t>(polygon[2])]);
  }
  return sum;
}

//------------------------------------------------------------------------------
/// The smallest angle of every polygon, in degrees.
std::vector<double> SmallestAngles(vtkPolyData* surface)
{
  const std::vector<Point> points = Sample::CoordinatesOf(surface);
  std::vector<double> angles;
  for (const Polygon& polygon : Sample::PolygonsOf(surface))
  {
    const std::size_t n = polygon.size();
    const auto corner = [&](std::size_t i)
    { return points[static_cast<std::size_t>(polygon[i % n])]; };
    double smallest = 180.0;
    for (std::size_t k = 0; k < n; ++k)
    {
      const Point u = Minus(corner(k + 1), corner(k));
      const Point v = Minus(corner(k + n - 1), corner(k));
      smallest = std::min(
        smallest, vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(u.data(), v.data())));
    }
    angles.push_back(smallest);
  }
  return angles;
}

//------------------------------------------------------------------------------
/// How often each directed edge occurs.
std::map<std::pair<vtkIdType, vtkIdType>, int> DirectedEdges(vtkPolyData* surface)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> edges;
  for (const Polygon& polygon : Sample::PolygonsOf(surface))
  {
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
      ++edges[{ polygon[k], polygon[(k + 1) % polygon.size()] }];
    }
  }
  return edges;
}

} // namespace

//------------------------------------------------------------------------------
testing::AssertionResult SameSurface(vtkPolyData* a, vtkPolyData* b, double tolerance)
{
  if (Sample::PolygonsOf(a) != Sample::PolygonsOf(b) ||
    a->GetNumberOfPoints() != b->GetNumberOfPoints())
  {
    return testing::AssertionFailure() << "the polygons differ";
  }
  const std::vector<Point> p = Sample::CoordinatesOf(a);
  const std::vector<Point> q = Sample::CoordinatesOf(b);
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const double distance = vtkMath::Norm(Minus(p[i], q[i]).data());
    if (!(distance <= tolerance))
    {
      return testing::AssertionFailure() << "point " << i << " is " << distance << " away";
    }
  }
  return testing::AssertionSuccess();
}

//------------------------------------------------------------------------------
double AreaOf(vtkPolyData* surface)
{
  return SumOverTriangles(surface,
    [](const Point& a, const Point& b, const Point& c)
    { return 0.5 * vtkMath::Norm(Cross(Minus(b, a), Minus(c, a)).data()); });
}

//------------------------------------------------------------------------------
double VolumeOf(vtkPolyData* surface)
{
  return SumOverTriangles(surface,
    [](const Point& a, const Point& b, const Point& c)
    { return vtkMath::Dot(a.data(), Cross(b, c).data()) / 6.0; });
}

//------------------------------------------------------------------------------
double SpreadOfAreas(vtkPolyData* surface)
{
  const std::vector<Point> points = Sample::CoordinatesOf(surface);
  double sum = 0.0;
  double squares = 0.0;
  for (const Polygon& polygon : Sample::PolygonsOf(surface))
  {
    double area = 0.0;
    for (std::size_t k = 2; k < polygon.size(); ++k)
    {
      const Point& origin = points[static_cast<std::size_t>(polygon[0])];
      const Point u = Minus(points[static_cast<std::size_t>(polygon[k - 1])], origin);
      const Point v = Minus(points[static_cast<std::size_t>(polygon[k])], origin);
      area += 0.5 * vtkMath::Norm(Cross(u, v).data());
    }
    sum += area;
    squares += area * area;
  }
  const auto count = static_cast<double>(surface->GetNumberOfPolys());
  const double mean = sum / count;
  return std::sqrt(squares / count - mean * mean) / mean;
}

//------------------------------------------------------------------------------
double SmallestAngleOf(vtkPolyData* surface)
{
  const std::vector<double> angles = SmallestAngles(surface);
  return *std::min_element(angles.begin(), angles.end());
}

//------------------------------------------------------------------------------
double MeanAngleOf(vtkPolyData* surface)
{
  const std::vector<double> angles = SmallestAngles(surface);
  return std::accumulate(angles.begin(), angles.end(), 0.0) / static_cast<double>(angles.size());
}

//------------------------------------------------------------------------------
int CountBadEdges(vtkPolyData* surface)
{
  const auto edges = DirectedEdges(surface);
  int bad = 0;
  for (const auto& [edge, count] : edges)
  {
    const auto opposite = edges.find({ edge.second, edge.first });
    bad += count != 1 || opposite == edges.end() || opposite->second != 1;
  }
  return bad;
}

//------------------------------------------------------------------------------
int EulerCharacteristic(vtkPolyData* surface)
{
  std::set<vtkIdType> points;
  std::set<std::pair<vtkIdType, vtkIdType>> edges;
  for (const auto& [edge, count] : DirectedEdges(surface))
  {
    points.insert(edge.first);
    edges.insert(std::minmax(edge.first, edge.second));
  }
  return static_cast<int>(points.size()) - static_cast<int>(edges.size()) +
    static_cast<int>(surface->GetNumberOfPolys());
}

//------------------------------------------------------------------------------
double LargestDistance(vtkPolyData* a, vtkPolyData* b)
{
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(b);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double largest = 0.0;
  for (const Point& point : Sample::CoordinatesOf(a))
  {
    double closest[3];
    double squared = 0.0;
    vtkIdType cellId = 0;
    int subId = 0;
    locator->FindClosestPoint(point.data(), closest, cell, cellId, subId, squared);
    largest = std::max(largest, std::sqrt(squared));
  }
  return largest;
}
