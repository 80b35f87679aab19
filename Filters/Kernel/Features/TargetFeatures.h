// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What is sharp on a target surface: its creases, corners and patches, and where the closest of
 * each is. The folder's front.
 */

#ifndef EVOLVING_TARGET_FEATURES_H
#define EVOLVING_TARGET_FEATURES_H

#include "Execution.h"
#include "Features/CapturableCreases.h"
#include "Features/FeatureCurves.h"
#include "Features/LabelBorders.h"
#include "Features/PolylineTree.h"
#include "Features/SharpEdges.h"
#include "Features/SurfacePatches.h"
#include "Features/TargetTriangles.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace evolving
{

/// A point of the surface.
struct LabelledPoint
{
  Index triangle = NoIndex; ///< NoIndex: there is none
  Index label = NoIndex;
  Vec3 point = Vec3::Zero();
  double squaredDistance = 0.0;
};

/**
 * Triangles have labels 0 ... labelCount() - 1 such that those on the sides of a kept crease
 * have different ones, so that label changes are a superset of the creases. Borders between
 * labels that are no creases are artificial: they only continue creases that end inside a patch.
 *
 * Numbers of triangles, vertices and edges are those of target(). Points, lengths and squared
 * distances are in the input's coordinates. All functions may be called from many threads; none
 * depends on the order of calls.
 */
class TargetFeatures
{
public:
  /// Use findFeatures().
  TargetFeatures(
    const SurfaceMesh& surface, const FeatureOptions& options, const Execution& execution);

  const TargetTriangles& target() const { return this->Target; }
  const SharpEdges& sharpEdges() const { return this->Sharp; }
  const FeatureCurves& curves() const { return this->Network; }
  const LabelBorders& borders() const { return this->Borders; }
  /// See tipsOf().
  const std::vector<Index>& tips() const { return this->Tips; }
  bool isTip(Index vertex) const
  {
    return std::binary_search(this->Tips.begin(), this->Tips.end(), vertex);
  }

  /// Are some of the creases edges of faceted parts? See takeFacetEdges().
  bool hasFacets() const { return this->Sharp.hasTakenIn(); }

  Index labelCount() const { return this->Labels.count; }
  Index labelOf(Index triangle) const { return this->Labels[triangle]; }
  /// How many pieces the creases alone cut the surface into: labels without artificial borders.
  Index patchCount() const { return this->Patches.count; }
  Index patchOf(Index triangle) const { return this->Patches[triangle]; }
  /// The sharp edges that elements cannot carry.
  const OmittedCreases& leftOut() const { return this->LeftOut; }
  /// The sharp edges beside triangles that are excluded.
  const OmittedCreases& excluded() const { return this->Excluded; }
  /// Is a triangle of a patch excluded?
  bool isExcludedPatch(Index patch) const { return this->IsExcludedPatch[at(patch)] != 0; }

  /// The closest point of the surface.
  LabelledPoint closestPoint(const Vec3& point) const;
  /**
   * The closest point of the triangles with a label.
   * @param squaredBound points farther than its root are not found
   */
  LabelledPoint closestPointWithLabel(const Vec3& point, Index label,
    double squaredBound = std::numeric_limits<double>::infinity()) const;

  /// The closest point of all creases; its curve is curves().curveOf(edge).
  EdgePoint closestOnCurves(const Vec3& point) const { return this->CurveTree.closest(point); }
  /// The closest of curves().corners(); NoIndex when there is none.
  Index closestCorner(const Vec3& point) const;

private:
  TargetTriangles Target;
  std::vector<char> IsExcluded; ///< of each triangle
  OmittedCreases LeftOut;       ///< before Sharp, whose construction sets it
  OmittedCreases Excluded;      ///< so, too
  SharpEdges Sharp;
  TriangleLabels Patches;
  std::vector<char> IsExcludedPatch;
  TriangleLabels Labels;
  FeatureCurves Network;
  LabelBorders Borders;
  std::vector<Index> Tips;
  AABBTree Tree;
  std::vector<std::vector<Index>> TrianglesOfLabel;
  std::vector<AABBTree> TreeOfLabel; ///< empty for one label: Tree
  PolylineTree CurveTree;
  AABBTree CornerTree;
};

/**
 * @param surface polygons of any orientation, open or closed, manifold or not, soup or welded
 * @throws InputError when the surface is damaged or has no face with three different corners,
 * or an option is out of its range
 * @throws Cancelled
 */
TargetFeatures findFeatures(
  const SurfaceMesh& surface, const FeatureOptions& options, const Execution& execution = {});

} // namespace evolving

#endif
