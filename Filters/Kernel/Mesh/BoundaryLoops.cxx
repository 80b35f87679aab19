// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/BoundaryLoops.h"

#include "Mesh/BoundaryCycles.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace evolving
{

namespace
{

/// From the farthest from the centre on: pairs that cannot be farther apart are not looked at.
double largestDistance(const std::vector<Vec3>& points)
{
  Vec3 centre = Vec3::Zero();
  for (const Vec3& point : points)
  {
    centre += (point - points[0]) / static_cast<double>(points.size());
  }
  centre += points[0];
  std::vector<std::pair<double, std::size_t>> byRadius;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    byRadius.emplace_back(-(points[k] - centre).norm(), k);
  }
  std::sort(byRadius.begin(), byRadius.end());
  double largest = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = 0; j < i && -byRadius[i].first - byRadius[j].first > largest; ++j)
    {
      const Vec3 between = points[byRadius[i].second] - points[byRadius[j].second];
      largest = std::max(largest, between.norm());
    }
  }
  return largest;
}

/// Turns the cycle round where most of its faces run the other way.
void followFaces(const SurfaceMesh& mesh, RimCycle& cycle)
{
  double along = 0.0;
  for (std::size_t k = 0; k < cycle.edges.size(); ++k)
  {
    const RimEdge& edge = cycle.edges[k];
    const double length = (mesh.points[at(edge.to)] - mesh.points[at(edge.from)]).norm();
    along += edge.from == cycle.vertices[k] ? length : -length;
  }
  if (along < 0.0)
  {
    // Vertex 0 stays first, so the edge that led to it comes first.
    std::reverse(cycle.vertices.begin() + 1, cycle.vertices.end());
    std::reverse(cycle.edges.begin(), cycle.edges.end());
  }
}

/// The unit normal of the face at edge k, turned so that the face runs along the cycle.
Vec3 normalAt(const SurfaceMesh& mesh, const RimCycle& cycle, std::size_t k)
{
  const RimEdge& edge = cycle.edges[k];
  const Vec3 normal = faceVectorArea(mesh, edge.face).normalized();
  return edge.from == cycle.vertices[k] ? normal : Vec3(-normal);
}

BoundaryLoop measured(const SurfaceMesh& mesh, RimCycle cycle)
{
  followFaces(mesh, cycle);
  std::vector<Vec3> points;
  for (const Index vertex : cycle.vertices)
  {
    points.push_back(mesh.points[at(vertex)]);
  }
  BoundaryLoop loop;
  loop.diameter = largestDistance(points);
  Vec3 weightedNormal = Vec3::Zero();
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const Vec3& next = points[(k + 1) % points.size()];
    const double length = (next - points[k]).norm();
    loop.perimeter += length;
    weightedNormal += length * normalAt(mesh, cycle, k);
    loop.vectorArea += 0.5 * (points[k] - points[0]).cross(next - points[0]);
  }
  // The cap that continues the faces runs against the loop.
  loop.continuation = -weightedNormal.dot(loop.vectorArea.normalized()) / loop.perimeter;
  loop.vertices = std::move(cycle.vertices);
  return loop;
}

} // namespace

std::vector<BoundaryLoop> boundaryLoops(const SurfaceMesh& mesh)
{
  std::vector<BoundaryLoop> loops;
  for (RimCycle& cycle : boundaryCycles(mesh))
  {
    const auto smallest = std::min_element(cycle.vertices.begin(), cycle.vertices.end());
    const std::ptrdiff_t shift = smallest - cycle.vertices.begin();
    std::rotate(cycle.vertices.begin(), smallest, cycle.vertices.end());
    std::rotate(cycle.edges.begin(), cycle.edges.begin() + shift, cycle.edges.end());
    loops.push_back(measured(mesh, std::move(cycle)));
  }
  std::sort(loops.begin(), loops.end(),
    [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.vertices < b.vertices; });
  return loops;
}

} // namespace evolving
