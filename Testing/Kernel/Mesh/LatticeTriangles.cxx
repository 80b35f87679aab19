// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticeTriangles.h"

#include <algorithm>

namespace evolving
{

namespace
{

using IntegerHull = std::vector<IntegerVector>;

bool separates(const IntegerVector& axis, const IntegerHull& p, const IntegerHull& q)
{
  std::int64_t extents[2][2];
  for (int i = 0; i < 2; ++i)
  {
    const IntegerHull& hull = i == 0 ? p : q;
    extents[i][0] = extents[i][1] = axis.dot(hull[0]);
    for (const IntegerVector& point : hull)
    {
      extents[i][0] = std::min(extents[i][0], axis.dot(point));
      extents[i][1] = std::max(extents[i][1], axis.dot(point));
    }
  }
  return extents[0][1] < extents[1][0] || extents[1][1] < extents[0][0];
}

/// By the separating axes of flat convex sets with area, in integers: slow and exact.
bool hullsMeet(const IntegerHull& p, const IntegerHull& q)
{
  std::vector<IntegerVector> edges;
  for (const IntegerHull* hull : { &p, &q })
  {
    for (std::size_t i = 0; i < hull->size(); ++i)
    {
      for (std::size_t j = i + 1; j < hull->size(); ++j)
      {
        edges.push_back((*hull)[j] - (*hull)[i]);
      }
    }
  }
  for (const IntegerVector& e : edges)
  {
    for (const IntegerVector& f : edges)
    {
      const IntegerVector normal = e.cross(f);
      if (separates(normal, p, q) || separates(normal.cross(e), p, q))
      {
        return false;
      }
    }
  }
  return true;
}

IntegerHull hullOf(const LatticeTriangles& mesh, const TriangleVertices& triangle)
{
  IntegerHull corners;
  for (const Index vertex : triangle)
  {
    corners.push_back(mesh.points[static_cast<std::size_t>(vertex)]);
  }
  return corners;
}

/// What is left of a triangle when a thousandth is cut off at its corner v; all times a thousand.
IntegerHull withoutCorner(const IntegerHull& triangle, const IntegerVector& v)
{
  IntegerHull rest;
  for (const IntegerVector& corner : triangle)
  {
    if (corner != v)
    {
      rest.push_back(999 * v + corner);
      rest.push_back(1000 * corner);
    }
  }
  return rest;
}

bool isFoldedFlat(const IntegerVector& a, const IntegerVector& b, const IntegerVector& firstApex,
  const IntegerVector& secondApex)
{
  const IntegerVector n = (b - a).cross(firstApex - a);
  const IntegerVector m = (b - a).cross(secondApex - a);
  return n.cross(m).isZero() && n.dot(m) > 0;
}

} // namespace

LatticeTriangles randomLatticeTriangles(std::mt19937& generator)
{
  std::uniform_int_distribution<int> coordinate(0, 4);
  std::uniform_int_distribution<Index> vertex(0, 11);
  LatticeTriangles mesh;
  for (int i = 0; i < 12; ++i)
  {
    mesh.points.emplace_back(coordinate(generator), coordinate(generator), coordinate(generator));
  }
  while (mesh.triangles.size() < 24)
  {
    const TriangleVertices triangle{ vertex(generator), vertex(generator), vertex(generator) };
    const IntegerHull hull = hullOf(mesh, triangle);
    if (!(hull[1] - hull[0]).cross(hull[2] - hull[0]).isZero())
    {
      mesh.triangles.push_back(triangle);
    }
  }
  return mesh;
}

bool latticeTrianglesIntersect(
  const LatticeTriangles& mesh, const TriangleVertices& first, const TriangleVertices& second)
{
  const auto point = [&](Index vertex) { return mesh.points[static_cast<std::size_t>(vertex)]; };
  std::vector<Index> shared;
  for (const Index vertex : first)
  {
    if (std::count(second.begin(), second.end(), vertex) > 0)
    {
      shared.push_back(vertex);
    }
  }
  const IntegerHull p = hullOf(mesh, first);
  const IntegerHull q = hullOf(mesh, second);
  if (shared.size() == 1)
  {
    return hullsMeet(withoutCorner(p, point(shared[0])), withoutCorner(q, point(shared[0])));
  }
  if (shared.size() == 2)
  {
    const auto apex = [&](const TriangleVertices& triangle)
    { return point(triangle[0] + triangle[1] + triangle[2] - shared[0] - shared[1]); };
    return isFoldedFlat(point(shared[0]), point(shared[1]), apex(first), apex(second));
  }
  return shared.size() == 3 || hullsMeet(p, q);
}

} // namespace evolving
