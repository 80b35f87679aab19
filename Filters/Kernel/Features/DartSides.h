// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The two sides of every crease that has one patch on both.
 */

#ifndef EVOLVING_DART_SIDES_H
#define EVOLVING_DART_SIDES_H

#include "Features/SeparatedSets.h"
#include "Features/SharpEdges.h"
#include "Features/SurfacePatches.h"
#include "Features/TargetTriangles.h"

#include <vector>

namespace evolving
{

/// Sets of triangles beside darts, joined along each side as far as a dart keeps two.
class DartSides
{
public:
  DartSides(const TargetTriangles& target, const SharpEdges& sharp, const TriangleLabels& patches);

  /// The triangles beside darts, ascending.
  const std::vector<Index>& seeds() const { return this->Seeds; }
  /// The length of the longest dart, with all that are connected to it.
  double longestDart() const { return this->LongestDart; }
  /// Of triangles; only seeds are joined and separated.
  SeparatedSets& sets() { return this->Sets; }

private:
  void addDart(const TargetTriangles& target, Index edge, Index left, Index right);
  void findDarts(
    const TargetTriangles& target, const SharpEdges& sharp, const TriangleLabels& patches);
  void measureDarts(const TargetTriangles& target);
  void joinAround(const TargetTriangles& target, const SharpEdges& sharp, Index vertex);

  std::vector<Index> Seeds;
  std::vector<Index> Vertices; ///< of darts, ascending
  std::vector<Index> Edges;    ///< of darts
  double LongestDart = 0.0;
  std::vector<char> IsSeed;
  SeparatedSets Sets;
};

} // namespace evolving

#endif
