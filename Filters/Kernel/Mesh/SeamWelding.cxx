// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SeamWelding.h"

#include "Mesh/DisjointSets.h"
#include "Mesh/TriangleEdges.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

std::pair<Index, Index> endsOf(const SurfaceMesh& mesh, Index corner)
{
  return std::minmax({ mesh.cornerVertices[at(corner)],
    mesh.cornerVertices[at(TriangleEdges::nextCorner(corner))] });
}

/// The ends of edges that are no longer than a tolerance.
std::set<std::pair<Index, Index>> shortEdges(
  const SurfaceMesh& mesh, const TriangleEdges& edges, double tolerance)
{
  std::set<std::pair<Index, Index>> ends;
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    const auto [a, b] = endsOf(mesh, *edges.begin(edge));
    if ((mesh.points[at(b)] - mesh.points[at(a)]).norm() <= tolerance)
    {
      ends.emplace(a, b);
    }
  }
  return ends;
}

/// The vertices of edges with one face.
std::vector<Index> openVertices(const SurfaceMesh& mesh, const TriangleEdges& edges)
{
  std::vector<Index> vertices;
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    if (edges.faceCount(edge) == 1)
    {
      const auto [a, b] = endsOf(mesh, *edges.begin(edge));
      vertices.push_back(a);
      vertices.push_back(b);
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

} // namespace

SurfaceMesh weldSeams(const SurfaceMesh& mesh, double tolerance)
{
  const TriangleEdges edges(mesh);
  const std::set<std::pair<Index, Index>> joined = shortEdges(mesh, edges, tolerance);
  std::vector<Index> open = openVertices(mesh, edges);
  const auto x = [&mesh](Index v) { return mesh.points[at(v)].x(); };
  std::stable_sort(open.begin(), open.end(), [&x](Index a, Index b) { return x(a) < x(b); });
  DisjointSets places(mesh.points.size());
  bool joins = false;
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    for (std::size_t j = i + 1; j < open.size() && x(open[j]) - x(open[i]) <= tolerance; ++j)
    {
      const bool isNear = (mesh.points[at(open[j])] - mesh.points[at(open[i])]).norm() <= tolerance;
      if (isNear && joined.count(std::minmax({ open[i], open[j] })) == 0)
      {
        places.join(open[i], open[j]);
        joins = true;
      }
    }
  }
  if (!joins)
  {
    return mesh;
  }
  SurfaceMesh closed = mesh;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    closed.points[at(v)] = mesh.points[at(places.find(v))];
  }
  return weldCoincidentPoints(closed);
}

double roundingOf(const SurfaceMesh& mesh)
{
  constexpr double Roundings = 4.0; // of two points, and of what they were computed from
  constexpr double OfNoSize = 1e-6; // of the diagonal
  const Box box = boundingBox(mesh);
  if (box.isEmpty())
  {
    return 0.0;
  }
  const double farthest =
    std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::min(
    Roundings * std::numeric_limits<float>::epsilon() * farthest, OfNoSize * box.diagonal().norm());
}

} // namespace evolving
