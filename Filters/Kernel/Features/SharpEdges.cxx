// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/SharpEdges.h"

#include "Features/FaceNormals.h"

#include <algorithm>

namespace evolving
{

namespace
{

constexpr double Tolerance = 0.01; ///< degrees: what points stored as floats leave of an angle

double largestFold(const TargetTriangles& target, const std::vector<Vec3>& normals, Index edge)
{
  double largest = target.edges().faceCount(edge) == 1 ? 180.0 : 0.0;
  for (const Index* a = target.edges().begin(edge); a != target.edges().end(edge); ++a)
  {
    for (const Index* b = a + 1; b != target.edges().end(edge); ++b)
    {
      largest = std::max(largest, foldAngle(target, normals, *a, *b));
    }
  }
  return largest;
}

} // namespace

SharpEdges::SharpEdges(
  const TargetTriangles& target, double angle, bool withBoundary, const Execution& execution)
  : Angle(angle)
  , Folds(static_cast<std::size_t>(target.edges().edgeCount()))
  , Sharp(static_cast<std::size_t>(target.edges().edgeCount()))
{
  const std::vector<Vec3> normals = faceNormals(target);
  execution.forRange(target.edges().edgeCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto e = static_cast<std::size_t>(begin); e < static_cast<std::size_t>(end); ++e)
      {
        const auto edge = static_cast<Index>(e);
        const Index faces = target.edges().faceCount(edge);
        this->Folds[e] = largestFold(target, normals, edge);
        this->Sharp[e] = faces > 2 || (faces == 1 ? withBoundary : this->foldsBeyond(edge, angle));
      }
    });
}

bool SharpEdges::foldsBeyond(Index edge, double angle) const
{
  return this->fold(edge) > angle + Tolerance;
}

double SharpEdges::relativeFold(Index edge) const
{
  constexpr double LeastAngle = 1.0;
  return std::min(this->fold(edge) / std::max(this->Angle, LeastAngle), 1.0);
}

std::vector<Index> SharpEdges::list() const
{
  std::vector<Index> edges;
  for (Index edge = 0; edge < static_cast<Index>(this->Sharp.size()); ++edge)
  {
    if (this->isSharp(edge))
    {
      edges.push_back(edge);
    }
  }
  return edges;
}

} // namespace evolving
