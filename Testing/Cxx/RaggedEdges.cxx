// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "RaggedEdges.h"

#include "ChangedSurfaces.h"
#include "SampleSurfaces.h"

#include "vtkMath.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace
{

using Sample::Point;
using Sample::Polygon;

/// Two points by number, the smaller one first.
using Edge = std::pair<vtkIdType, vtkIdType>;

/// A surface's sharp edges, and at each point the other ends of those that meet there.
struct SharpEdges
{
  std::vector<Point> Points;
  std::vector<Edge> Edges;
  std::map<vtkIdType, std::vector<vtkIdType>> Ends;
};

//------------------------------------------------------------------------------
Point From(const Point& a, const Point& b)
{
  return { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
}

//------------------------------------------------------------------------------
double AngleBetween(const Point& u, const Point& v)
{
  return vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(u.data(), v.data()));
}

//------------------------------------------------------------------------------
/// The normals of the triangles at every edge.
std::map<Edge, std::vector<Point>> NormalsAtEdges(
  const std::vector<Point>& points, const std::vector<Polygon>& triangles)
{
  std::map<Edge, std::vector<Point>> normals;
  for (const Polygon& triangle : triangles)
  {
    const auto corner = [&](std::size_t k) -> const Point&
    { return points[static_cast<std::size_t>(triangle[k])]; };
    Point normal;
    vtkMath::Cross(
      From(corner(0), corner(1)).data(), From(corner(0), corner(2)).data(), normal.data());
    for (std::size_t k = 0; k < 3; ++k)
    {
      normals[std::minmax(triangle[k], triangle[(k + 1) % 3])].push_back(normal);
    }
  }
  return normals;
}

//------------------------------------------------------------------------------
/// Edges that fold by more than an angle, or have not two triangles.
SharpEdges SharpEdgesOf(vtkPolyData* surface, double angle)
{
  SharpEdges sharp;
  sharp.Points = Sample::CoordinatesOf(surface);
  const auto triangles = Sample::PolygonsOf(Sample::Triangulated(surface));
  for (const auto& [edge, normals] : NormalsAtEdges(sharp.Points, triangles))
  {
    if (normals.size() != 2 || AngleBetween(normals[0], normals[1]) > angle)
    {
      sharp.Edges.push_back(edge);
      sharp.Ends[edge.first].push_back(edge.second);
      sharp.Ends[edge.second].push_back(edge.first);
    }
  }
  return sharp;
}

//------------------------------------------------------------------------------
/// Does an edge that comes from a point continue beyond its end as a line does?
bool Continues(const SharpEdges& sharp, vtkIdType from, vtkIdType end)
{
  const auto at = [&](vtkIdType i) -> const Point&
  { return sharp.Points[static_cast<std::size_t>(i)]; };
  const auto& others = sharp.Ends.at(end);
  return std::any_of(others.begin(), others.end(),
    [&](vtkIdType next) {
      return next != from && AngleBetween(From(at(from), at(end)), From(at(end), at(next))) <= 40.0;
    });
}

//------------------------------------------------------------------------------
/// Points where a surface's edges end, branch or turn.
std::vector<Point> CornersOf(vtkPolyData* surface)
{
  const SharpEdges sharp = SharpEdgesOf(surface, 40.0);
  std::vector<Point> corners;
  for (const auto& [point, others] : sharp.Ends)
  {
    if (others.size() != 2 || !Continues(sharp, others[0], point))
    {
      corners.push_back(sharp.Points[static_cast<std::size_t>(point)]);
    }
  }
  return corners;
}

//------------------------------------------------------------------------------
double MeanEdgeLength(vtkPolyData* surface)
{
  const auto points = Sample::CoordinatesOf(surface);
  double sum = 0.0;
  const auto triangles = Sample::PolygonsOf(surface);
  for (const Polygon& triangle : triangles)
  {
    sum += std::sqrt(
      vtkMath::Distance2BetweenPoints(points[static_cast<std::size_t>(triangle[0])].data(),
        points[static_cast<std::size_t>(triangle[1])].data()));
  }
  return sum / static_cast<double>(triangles.size());
}

//------------------------------------------------------------------------------
double LengthOf(const SharpEdges& sharp, const Edge& edge)
{
  return std::sqrt(
    vtkMath::Distance2BetweenPoints(sharp.Points[static_cast<std::size_t>(edge.first)].data(),
      sharp.Points[static_cast<std::size_t>(edge.second)].data()));
}

} // namespace

//------------------------------------------------------------------------------
double SharpLengthOf(vtkPolyData* surface)
{
  const SharpEdges sharp = SharpEdgesOf(surface, 30.0);
  double length = 0.0;
  for (const Edge& edge : sharp.Edges)
  {
    length += LengthOf(sharp, edge);
  }
  return length;
}

//------------------------------------------------------------------------------
double RaggedLengthOf(vtkPolyData* surface, vtkPolyData* target)
{
  const SharpEdges sharp = SharpEdgesOf(surface, 30.0);
  const std::vector<Point> corners = CornersOf(target);
  const double near = MeanEdgeLength(surface);
  const auto isAtCorner = [&](vtkIdType i)
  {
    const Point& point = sharp.Points[static_cast<std::size_t>(i)];
    return std::any_of(corners.begin(), corners.end(),
      [&](const Point& corner)
      { return vtkMath::Distance2BetweenPoints(point.data(), corner.data()) < near * near; });
  };
  const auto breaksOff = [&](vtkIdType from, vtkIdType end)
  { return !Continues(sharp, from, end) && !isAtCorner(end); };
  double length = 0.0;
  for (const Edge& edge : sharp.Edges)
  {
    const bool isRagged = breaksOff(edge.first, edge.second) || breaksOff(edge.second, edge.first);
    length += isRagged ? LengthOf(sharp, edge) : 0.0;
  }
  return length;
}
