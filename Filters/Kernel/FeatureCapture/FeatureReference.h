// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a surface lies on that has captured the creases of a target.
 */

#ifndef EVOLVING_FEATURE_REFERENCE_H
#define EVOLVING_FEATURE_REFERENCE_H

#include "Execution.h"
#include "Features/PolylineTree.h"
#include "Features/TargetFeatures.h"
#include "Remeshing/ReferenceSurface.h"
#include "Trees/AABBTree.h"

#include <vector>

namespace evolving
{

/**
 * Faces with the number of a patch lie on that patch, edges with the number of a curve on that
 * curve (TargetFeatures). All else lies on another reference.
 */
class FeatureReference : public ReferenceSurface
{
public:
  /// A face's label that belongs to no patch.
  static constexpr Index NoPatch = -1;

  /**
   * @param others where there is no patch; kept, like the features
   * @param reach points farther away from their patch have no place there
   * @throws Cancelled
   */
  FeatureReference(const ReferenceSurface& others, const TargetFeatures& features, double reach,
    const Execution& execution = {});

  Foot onSurface(const Vec3& point, const Vec3& facing, Index label, Index guess) const override;
  Vec3 onCurve(const Vec3& point, Index curve) const override;

private:
  const ReferenceSurface& Others;
  double SquaredReach;
  std::vector<AABBTree> Patches;
  std::vector<PolylineTree> Curves;
};

} // namespace evolving

#endif
