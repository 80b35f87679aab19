// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which creases of a target shrink-wrapping is to preserve.
 */

#ifndef EVOLVING_WRAP_FEATURES_H
#define EVOLVING_WRAP_FEATURES_H

#include "Features/CapturableCreases.h"
#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapReference.h"

namespace evolving
{

/// Those of WrapReference::visible(), but not at sheets, which become walls without creases.
inline FeatureOptions wantedFeatures(
  const ShrinkWrapOptions& options, const WrapReference& reference, double edgeLength)
{
  FeatureOptions features;
  features.angle = options.featureAngle;
  features.edgeLength = edgeLength;
  features.onlyDistinct = options.preserveFeatures == FeaturePreservation::Automatic;
  if (reference.hasSheets())
  {
    features.isExcluded = [&reference](const Vec3& p) { return reference.isAtSheet(p); };
  }
  return features;
}

} // namespace evolving

#endif
