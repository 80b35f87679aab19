// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which labels of the target each vertex of a surface lies on.
 */

#ifndef EVOLVING_VERTEX_LABELS_H
#define EVOLVING_VERTEX_LABELS_H

#include "Execution.h"
#include "FeatureCapture/LabelSets.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"

#include <unordered_set>
#include <vector>

namespace evolving
{

/**
 * One label for a vertex inside a label, two on a border, three or more where borders meet. Corners
 * of the target take the vertices next to them, and vertices near a border move onto it, so that
 * what is cut there later is not cut in slivers.
 */
class VertexLabels
{
public:
  /// @throws Cancelled
  VertexLabels(
    EditableSurface& surface, const TargetFeatures& features, const Execution& execution);

  const Labels& of(Index v) const { return this->Sets[at(v)]; }
  void add(Index v, Index label);
  /// Of the vertex that a split has just made.
  void append(const Labels& labels);

  /// The vertex of the target that a vertex has been put on; NoIndex for most.
  Index corner(Index v) const { return this->Corners[at(v)]; }
  void setCorner(Index v, Index targetVertex)
  {
    this->Corners[at(v)] = targetVertex;
    this->Taken.insert(targetVertex);
  }
  /// Has a vertex been put on a vertex of the target?
  bool isTaken(Index targetVertex) const { return this->Taken.count(targetVertex) > 0; }
  /// Neither held nor on a corner.
  bool mayMove(const EditableSurface& surface, Index v) const;

private:
  void takeCorners(EditableSurface& surface, const TargetFeatures& features);
  void snapToBorders(EditableSurface& surface, const TargetFeatures& features);

  std::vector<Labels> Sets;
  std::vector<Index> Corners;
  std::unordered_set<Index> Taken; ///< all corners
};

} // namespace evolving

#endif
