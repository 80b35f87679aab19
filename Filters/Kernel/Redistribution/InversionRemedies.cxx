// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/InversionRemedies.h"

#include "Operators/ElementShape.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace evolving
{

namespace
{

constexpr int ReshapingSweeps = 2;
/// Of the longest move around: what comes from a step is undone by less than a step. Without such a
/// bound points wander off over the folds of a surface that has collapsed.
constexpr double LargestReshapingPart = 0.5;

std::set<Index> verticesOf(const SurfaceMesh& mesh, const std::vector<Index>& faces)
{
  std::set<Index> vertices;
  for (const Index face : faces)
  {
    for (Index k = 0; k < mesh.faceSize(face); ++k)
    {
      vertices.insert(mesh.faceVertex(face, k));
    }
  }
  return vertices;
}

/// Of the moves of a vertex and its neighbours.
double longestAround(const MeshTopology& topology, const std::vector<Vec3>& moves, Index vertex)
{
  double longest = moves[at(vertex)].norm();
  for (const Index neighbour : topology.ringVertices(vertex))
  {
    longest = std::max(longest, moves[at(neighbour)].norm());
  }
  return longest;
}

} // namespace

void reshape(const SurfaceMesh& mesh, const MeshTopology& topology,
  const std::vector<Vec3>& normals, const std::vector<Index>& faces, std::vector<Vec3>& moves)
{
  SurfaceMesh moved = mesh;
  const std::set<Index> vertices = verticesOf(mesh, faces);
  for (int sweep = 0; sweep < ReshapingSweeps; ++sweep)
  {
    for (const Index vertex : vertices)
    {
      moved.points[at(vertex)] +=
        bestShapeMove(moved, topology, vertex, normals[at(vertex)], Vec3::Zero());
    }
  }
  for (const Index vertex : vertices)
  {
    const Vec3 way = moved.points[at(vertex)] - mesh.points[at(vertex)];
    const double farthest = LargestReshapingPart * longestAround(topology, moves, vertex);
    moves[at(vertex)] += way.norm() > farthest ? Vec3(farthest / way.norm() * way) : way;
  }
}

void shorten(const SurfaceMesh& mesh, const std::vector<Index>& faces, double factor,
  std::vector<double>& fraction)
{
  for (const Index vertex : verticesOf(mesh, faces))
  {
    fraction[at(vertex)] *= factor;
  }
}

void evenOut(const SurfaceMesh& mesh, const std::vector<Index>& faces, std::vector<Vec3>& moves)
{
  std::map<Index, std::pair<Vec3, int>> means;
  for (const Index face : faces)
  {
    Vec3 mean = Vec3::Zero();
    for (Index k = 0; k < mesh.faceSize(face); ++k)
    {
      mean += moves[at(mesh.faceVertex(face, k))] / mesh.faceSize(face);
    }
    for (Index k = 0; k < mesh.faceSize(face); ++k)
    {
      auto& sum = means.try_emplace(mesh.faceVertex(face, k), Vec3::Zero(), 0).first->second;
      sum.first += mean;
      ++sum.second;
    }
  }
  for (const auto& [vertex, sum] : means)
  {
    moves[at(vertex)] = sum.first / sum.second;
  }
}

} // namespace evolving
