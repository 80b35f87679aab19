// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which creases of a target shrink-wrapping is to preserve.
 */

#ifndef EVOLVING_WRAP_FEATURES_H
#define EVOLVING_WRAP_FEATURES_H

#include "FeatureCapture/FeatureRelease.h"
#include "Features/CapturableCreases.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/CoveringTriangles.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapReference.h"
#include "ShrinkWrap/WrapTuning.h"

namespace evolving
{

/// In edges of the result: so long facets are large. With 9000 points those of scans, and of models
/// that animators subdivide, are two and a half at most, of figures of few triangles four and more.
constexpr double FacetEdges = 3.0;

/// Of the edges that are asked for, before creases make them vary.
inline double facetLength(const ShrinkWrapOptions& options, const WrapReference& reference)
{
  const double area = surfaceArea(reference.visible());
  const int points = options.targetNumberOfPoints;
  const double automatic =
    points > 0 ? coveringEdgeLength(area, points) : defaultEdgeLength(area, 0.0);
  return FacetEdges * (options.targetEdgeLength > 0.0 ? options.targetEdgeLength : automatic);
}

/// Those of WrapReference::visible(), but not at sheets, which become walls without creases.
inline FeatureOptions wantedFeatures(
  const ShrinkWrapOptions& options, const WrapReference& reference, double edgeLength)
{
  FeatureOptions features;
  features.angle = options.featureAngle;
  features.edgeLength = edgeLength;
  features.onlyDistinct = options.preserveFeatures == FeaturePreservation::Automatic;
  features.facetLength = facetLength(options, reference);
  if (reference.hasSheets())
  {
    features.isExcluded = [&reference](const Vec3& p) { return reference.isAtSheet(p); };
  }
  return features;
}

/// What creases that are captured may cost elements.
inline CreaseWorth creaseWorth(
  const ShrinkWrapOptions& options, const TargetFeatures& features, const FinishTuning& tuning)
{
  const bool areWanted =
    options.preserveFeatures == FeaturePreservation::On || features.hasFacets();
  CreaseWorth worth;
  worth.angle = areWanted ? tuning.leastFeatureAngle : tuning.leastAutomaticAngle;
  worth.atTips = tuning.leastFeatureAngle;
  for (const FeatureCurve& curve : features.curves().curves())
  {
    worth.folds.push_back(curve.fold);
  }
  return worth;
}

} // namespace evolving

#endif
