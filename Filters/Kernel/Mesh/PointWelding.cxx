// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PointWelding.h"

#include "Mesh/SurfaceMesh.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace evolving
{

namespace
{

/// The face's vertices after welding, without consecutive repetitions.
std::vector<Index> weldedFace(const SurfaceMesh& mesh, Index face, const std::vector<Index>& first)
{
  std::vector<Index> vertices;
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    const Index vertex = first[at(mesh.faceVertex(face, k))];
    if (vertices.empty() || vertices.back() != vertex)
    {
      vertices.push_back(vertex);
    }
  }
  while (vertices.size() > 1 && vertices.front() == vertices.back())
  {
    vertices.pop_back();
  }
  return vertices;
}

bool hasRepeatedVertex(std::vector<Index> vertices)
{
  std::sort(vertices.begin(), vertices.end());
  return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
}

} // namespace

std::vector<Index> firstOfEqualPoints(const std::vector<Vec3>& points, std::vector<Index> among)
{
  const auto less = [&points](Index a, Index b)
  {
    const Vec3& p = points[at(a)];
    const Vec3& q = points[at(b)];
    return std::tie(p[0], p[1], p[2], a) < std::tie(q[0], q[1], q[2], b);
  };
  std::sort(among.begin(), among.end(), less);
  std::vector<Index> first(points.size(), NoIndex);
  for (std::size_t i = 0; i < among.size(); ++i)
  {
    const bool equalsLast = i > 0 && points[at(among[i])] == points[at(among[i - 1])];
    first[at(among[i])] = equalsLast ? first[at(among[i - 1])] : among[i];
  }
  return first;
}

std::vector<Index> vertexOfEachPoint(
  const std::vector<Vec3>& points, const std::vector<Vec3>& vertices)
{
  // Vertices come first, so that the first of equal points is a vertex where there is one.
  std::vector<Vec3> all = vertices;
  all.insert(all.end(), points.begin(), points.end());
  std::vector<Index> finite;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (all[i].allFinite())
    {
      finite.push_back(static_cast<Index>(i));
    }
  }
  std::vector<Index> vertex = firstOfEqualPoints(all, std::move(finite));
  vertex.erase(vertex.begin(), vertex.begin() + static_cast<std::ptrdiff_t>(vertices.size()));
  const auto count = static_cast<Index>(vertices.size());
  std::replace_if(
    vertex.begin(), vertex.end(), [count](Index v) { return v >= count; }, NoIndex);
  return vertex;
}

std::vector<Index> usedVertices(const SurfaceMesh& mesh)
{
  std::vector<char> used(mesh.points.size(), 0);
  for (const Index v : mesh.cornerVertices)
  {
    used[at(v)] = 1;
  }
  std::vector<Index> vertices;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (used[at(v)])
    {
      vertices.push_back(v);
    }
  }
  return vertices;
}

void dropUnusedPoints(SurfaceMesh& mesh, std::vector<Index>* oldVertex)
{
  std::vector<Index> used = usedVertices(mesh);
  std::vector<Index> number(mesh.points.size(), NoIndex);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    number[at(used[i])] = static_cast<Index>(i);
    mesh.points[i] = mesh.points[at(used[i])];
  }
  mesh.points.resize(used.size());
  for (Index& vertex : mesh.cornerVertices)
  {
    vertex = number[at(vertex)];
  }
  if (oldVertex)
  {
    *oldVertex = std::move(used);
  }
}

SurfaceMesh weldCoincidentPoints(
  const SurfaceMesh& mesh, std::vector<Index>* oldVertex, std::vector<Index>* oldFace)
{
  // Unused points stay out of it: they may be NaN.
  return joinVertices(
    mesh, firstOfEqualPoints(mesh.points, usedVertices(mesh)), oldVertex, oldFace);
}

SurfaceMesh joinVertices(const SurfaceMesh& mesh, const std::vector<Index>& first,
  std::vector<Index>* oldVertex, std::vector<Index>* oldFace)
{
  SurfaceMesh welded;
  welded.cornerVertices.reserve(mesh.cornerVertices.size());
  welded.faceOffsets.reserve(mesh.faceOffsets.size());
  if (oldFace)
  {
    oldFace->clear();
  }
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const std::vector<Index> vertices = weldedFace(mesh, face, first);
    if (vertices.size() >= 3 && !hasRepeatedVertex(vertices))
    {
      welded.addFace(vertices);
      if (oldFace)
      {
        oldFace->push_back(face);
      }
    }
  }
  welded.points = mesh.points;
  dropUnusedPoints(welded, oldVertex);
  return welded;
}

} // namespace evolving
