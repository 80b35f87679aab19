// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/DistinctCreases.h"

#include "Mesh/ConnectedComponents.h"

#include <vector>

namespace evolving
{

namespace
{

/// A crease folds so many times as much as the edges beside it: of machined parts nearly all do,
/// cylinders of eight sides a quarter round included; of scans and figures a fifth to two fifths.
constexpr double DistinctFold = 6.0;
constexpr double LeastShare = 0.5;

/// The mean fold of the edges around the faces of an edge, but for sharp and open ones.
double foldBeside(const TargetTriangles& target, const SharpEdges& sharp, Index edge)
{
  double sum = 0.0;
  int count = 0;
  for (const Index* c = target.edges().begin(edge); c != target.edges().end(edge); ++c)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Index other = target.edgeOfFace(TargetTriangles::faceOf(*c), k);
      if (!sharp.isSharp(other) && target.edges().faceCount(other) > 1)
      {
        sum += sharp.fold(other);
        ++count;
      }
    }
  }
  return count > 0 ? sum / count : 0.0;
}

struct CreaseLengths
{
  double all = 0.0;
  double distinct = 0.0;
};

} // namespace

void keepDistinctCreases(const TargetTriangles& target, SharpEdges& sharp)
{
  const std::vector<Index> edges = sharp.list();
  const ConnectedComponents parts = connectedComponents(target.mesh());
  const auto partOf = [&](Index edge)
  { return at(parts.ofVertex[at(target.edgeVertices(edge)[0])]); };
  std::vector<CreaseLengths> lengths(at(parts.count));
  for (const Index edge : edges)
  {
    CreaseLengths& part = lengths[partOf(edge)];
    const double length = target.edgeLength(edge);
    part.all += length;
    const bool isDistinct = sharp.fold(edge) > DistinctFold * foldBeside(target, sharp, edge);
    part.distinct += isDistinct ? length : 0.0;
  }
  for (const Index edge : edges)
  {
    const CreaseLengths& part = lengths[partOf(edge)];
    if (part.distinct <= LeastShare * part.all)
    {
      sharp.leaveOut(edge);
    }
  }
}

} // namespace evolving
