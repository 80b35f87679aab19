// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Shrink-wrapping with PreserveFeatures of polyhedra that fold by less than the angle of creases.

#include "Checks/SurfaceMeasures.h"
#include "ShrinkWrap/FeatureWraps.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

namespace
{

using namespace evolving;
using namespace evolving::wraps;

TEST(WrapFacets, LargeFacetsHaveTheirEdges)
{
  // An icosahedron folds by less than the angle of creases, but is no sphere.
  ShrinkWrapOptions options = quick(0.15, 48);
  options.preserveFeatures = FeaturePreservation::Automatic;
  const SurfaceMesh target = icosphere(0);
  const Wrapped faceted(target, options);
  expectSound(faceted.surface, 0);
  EXPECT_LT(checks::hausdorff(faceted.surface, target, 0.05), 1e-12);
  EXPECT_EQ(faceted.report.creases.missing, 0.0);
  options.preserveFeatures = FeaturePreservation::Off;
  const Wrapped smooth(target, options);
  EXPECT_GT(checks::hausdorff(smooth.surface, target, 0.05), 1e-3);
}

TEST(WrapFacets, LargeFacetsHaveTheirFaintEdges)
{
  // Flattened, an icosahedron folds by 69 degrees around its waist and by 21 at its poles.
  SurfaceMesh target = icosphere(0);
  for (Vec3& point : target.points)
  {
    point.z() *= 0.5;
  }
  ShrinkWrapOptions options = quick(0.12, 56);
  options.preserveFeatures = FeaturePreservation::Automatic;
  const Wrapped wrapped(target, options);
  expectSound(wrapped.surface, 0, 1, 22.0);
  EXPECT_EQ(wrapped.report.creases.missing, 0.0);
  EXPECT_LT(checks::hausdorff(wrapped.surface, target, 0.05), 1e-12);
}

} // namespace
