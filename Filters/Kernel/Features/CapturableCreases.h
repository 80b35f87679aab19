// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which sharp edges of a target are worth elements along them.
 */

#ifndef EVOLVING_CAPTURABLE_CREASES_H
#define EVOLVING_CAPTURABLE_CREASES_H

#include "Execution.h"
#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <functional>
#include <vector>

namespace evolving
{

struct FeatureOptions
{
  /// An edge is sharp where normals differ by more, in degrees, 0 to 180.
  double angle = 45.0;
  /// Of the elements that are to carry the creases, in the target's unit; creases that they cannot
  /// carry are left out, see keepCarriable(). 0 keeps all.
  double edgeLength = 0.0;
  /// Are parts without creases, but with folds, left alone? See keepDistinctCreases().
  bool onlyDistinct = false;
  /// Then parts are faceted, and have their edges, where these are so long on average, in the
  /// target's unit; see takeFacetEdges(). 0: none are.
  double facetLength = 0.0;
  /// Do edges of one face count as sharp? They have one label.
  bool withBoundary = false;
  /// Where the surface is not wanted with its creases; by the middles of its triangles. May be
  /// null.
  std::function<bool(const Vec3& point)> isExcluded = nullptr;
};

/// Some creases, of which none is kept.
struct OmittedCreases
{
  double length = 0.0;
  Vec3 place = Vec3::Zero(); ///< on one
};

/// The length of some edges.
double lengthOf(const TargetTriangles& target, const std::vector<Index>& edges);

/// Triangles where creases are not wanted: FeatureOptions::isExcluded.
std::vector<char> excludedTriangles(const TargetTriangles& target, const FeatureOptions& options);

/**
 * The sharp edges of a target, without those that do not stand out, where only distinct ones are
 * wanted, but for those of faceted parts, and without those beside excluded triangles; however
 * small elements have to be for them.
 * @param[out] excluded these last
 * @throws Cancelled
 */
SharpEdges capturableCreases(const TargetTriangles& target, const FeatureOptions& options,
  const std::vector<char>& isExcluded, OmittedCreases& excluded, const Execution& execution = {});

/// Of some edges those that are not sharp any more.
OmittedCreases omittedOf(
  const TargetTriangles& target, const std::vector<Index>& edges, const SharpEdges& sharp);

} // namespace evolving

#endif
