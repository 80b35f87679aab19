// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CarriableFeatures.h"

#include "Features/CloseCurves.h"
#include "Features/FeatureCurves.h"
#include "Features/NarrowPatches.h"
#include "Mesh/DisjointSets.h"

#include <vector>

namespace evolving
{

namespace
{

constexpr double LeastCrease = 2.0;   ///< the length of all that is connected, over L
constexpr double LeastLooseEnd = 1.0; ///< of a curve with a loose end, over L

void leaveOut(SharpEdges& sharp, const FeatureCurve& curve)
{
  for (const Index edge : curve.edges)
  {
    sharp.leaveOut(edge);
  }
}

bool dropShortCreases(const TargetTriangles& target, SharpEdges& sharp, double edgeLength)
{
  const FeatureCurves network(target, sharp);
  DisjointSets connected(target.mesh().points.size());
  std::vector<double> lengths(target.mesh().points.size(), 0.0);
  for (const FeatureCurve& curve : network.curves())
  {
    connected.join(curve.vertices.front(), curve.vertices.back());
  }
  for (const FeatureCurve& curve : network.curves())
  {
    lengths[static_cast<std::size_t>(connected.find(curve.vertices.front()))] += curve.length;
  }
  bool dropped = false;
  for (const FeatureCurve& curve : network.curves())
  {
    const Index from = curve.vertices.front();
    const Index to = curve.vertices.back();
    const bool isLoose = network.valence(from) == 1 || network.valence(to) == 1;
    if (lengths[static_cast<std::size_t>(connected.find(from))] < LeastCrease * edgeLength ||
      (isLoose && curve.length < LeastLooseEnd * edgeLength))
    {
      leaveOut(sharp, curve);
      dropped = true;
    }
  }
  return dropped;
}

} // namespace

void keepCarriable(
  const TargetTriangles& target, SharpEdges& sharp, double edgeLength, const Execution& execution)
{
  if (!(edgeLength > 0.0))
  {
    return;
  }
  // Every round leaves edges out, so there is a last one.
  for (bool changed = true; changed;)
  {
    changed = dropShortCreases(target, sharp, edgeLength);
    execution.report(0.2);
    changed = mergeNarrowPatches(target, sharp, LeastCarriableWidth * edgeLength) || changed;
    execution.report(0.6);
    changed = dropCloseCurves(target, sharp, LeastCarriableWidth * edgeLength) || changed;
  }
  execution.report(1.0);
}

} // namespace evolving
