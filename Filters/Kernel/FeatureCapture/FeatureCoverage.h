// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How much of the target's creases a surface carries.
 */

#ifndef EVOLVING_FEATURE_COVERAGE_H
#define EVOLVING_FEATURE_COVERAGE_H

#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

namespace evolving
{

struct FeatureCoverage
{
  double length = 0.0;       ///< of the creases that elements can carry
  double missing = 0.0;      ///< of those that no edge of the surface lies on
  Vec3 place = Vec3::Zero(); ///< on one that is missing
  OmittedCreases leftOut;    ///< that elements cannot carry
};

/**
 * @param surface with its edges on creases marked, EditableSurface::curve()
 * @param spacing of the points of the creases that are looked for
 * @param tolerance how near to an edge of the surface they have to be
 */
FeatureCoverage featureCoverage(
  const EditableSurface& surface, const TargetFeatures& features, double spacing, double tolerance);

} // namespace evolving

#endif
