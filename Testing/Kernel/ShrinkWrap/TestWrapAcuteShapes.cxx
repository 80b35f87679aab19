// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Shrink-wrapping of edges and tips that are thinner than elements before they are captured.

#include "Checks/SurfaceMeasures.h"
#include "Mesh/MeshQuality.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "ShrinkWrap/FeatureWraps.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace evolving;
using namespace evolving::wraps;

TEST(WrapAcuteShapes, AcuteCreasesAreNotWornOff)
{
  // Between planes at 34 and at 45 degrees.
  const SurfaceMesh prism =
    shapes::extruded({ Vec3(0, 0, 0), Vec3(1.5, 0, 0), Vec3(0, 1, 0) }, 1.2);
  const Wrapped ofPrism(prism, withFeatures(0.12));
  expectSound(ofPrism.surface, 0, 1, 30.0);
  EXPECT_LT(ofPrism.report.creases.missing, 0.01 * ofPrism.report.creases.length);
  EXPECT_LT(checks::hausdorff(ofPrism.surface, prism, 0.05), 0.05);
  const Wrapped ofCone(shapes::cone(), withFeatures(0.15));
  expectSound(ofCone.surface, 0, 1, 30.0);
  EXPECT_EQ(ofCone.report.creases.missing, 0.0);
}

TEST(WrapAcuteShapes, SpikesKeepTheirTips)
{
  // Two, of four sides of 29.5 degrees each, as four elements have them.
  SurfaceMesh target = shapes::octahedron();
  for (Vec3& point : target.points)
  {
    point = point.cwiseProduct(Vec3(0.5, 0.5, 1.3));
  }
  ShrinkWrapOptions options = quick(0.08, 64);
  options.preserveFeatures = FeaturePreservation::Automatic;
  const Wrapped wrapped(target, options);
  expectSound(wrapped.surface, 0, 1, 22.0);
  EXPECT_LT(checks::hausdorff(wrapped.surface, target, 0.02), 1e-12);
}

TEST(WrapAcuteShapes, BladesKeepTheirEdges)
{
  std::mt19937 generator(5);
  for (const double degrees : { 8.0, 20.0 })
  {
    const Eigen::Matrix3d turn = shapes::randomRotation(generator);
    const SurfaceMesh target = shapes::mapped(shapes::blade(degrees, 10.0, 4.0), turn);
    ShrinkWrapOptions options;
    options.targetNumberOfPoints = 3000;
    options.preserveFeatures = FeaturePreservation::Automatic;
    const Wrapped wrapped(target, options);
    expectSound(wrapped.surface, 0, 1, 20.0);
    // Without its edge a blade of 8 degrees is shorter by three edges of elements.
    const double edge = meanEdgeLength(wrapped.surface);
    const AABBTree result(wrapped.surface);
    for (double z = 0.8; z <= 3.2; z += 0.05)
    {
      EXPECT_LT(std::sqrt(result.closest(turn * Vec3(0, 0, z)).at.squaredDistance), 1e-9)
        << degrees << " degrees at " << z;
    }
    EXPECT_LT(checks::hausdorff(wrapped.surface, target, 0.1), edge) << degrees;
  }
}

} // namespace
