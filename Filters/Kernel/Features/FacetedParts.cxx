// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/FacetedParts.h"

#include "Mesh/ConnectedComponents.h"

#include <vector>

namespace evolving
{

namespace
{

/// The folds of a part.
struct PartFolds
{
  bool hasSharp = false;
  double length = 0.0;
  double squared = 0.0; ///< the sum of squared lengths
};

} // namespace

void takeFacetEdges(
  const TargetTriangles& target, SharpEdges& sharp, double angle, double leastMean)
{
  const ConnectedComponents parts = connectedComponents(target.mesh());
  const auto partOf = [&](Index edge)
  { return at(parts.ofVertex[at(target.edgeVertices(edge)[0])]); };
  std::vector<PartFolds> folds(at(parts.count));
  std::vector<Index> folded;
  for (Index edge = 0; edge < target.edges().edgeCount(); ++edge)
  {
    PartFolds& part = folds[partOf(edge)];
    part.hasSharp = part.hasSharp || sharp.isSharp(edge);
    if (target.edges().faceCount(edge) == 2 && sharp.foldsBeyond(edge, angle))
    {
      const double length = target.edgeLength(edge);
      part.length += length;
      part.squared += length * length;
      folded.push_back(edge);
    }
  }
  for (const Index edge : folded)
  {
    const PartFolds& part = folds[partOf(edge)];
    if (!part.hasSharp && part.squared >= leastMean * part.length)
    {
      sharp.takeIn(edge);
    }
  }
}

} // namespace evolving
