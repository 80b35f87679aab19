// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/FeatureCoverage.h"

#include "FeatureCapture/CaptureShapes.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace evolving;

/// The box from -1 to 1 with edges of 0.25 on all its creases.
EditableSurface markedBox()
{
  EditableSurface surface(shapes::triangleBox(8, Vec3(1, 1, 1)));
  shapes::markCreases(surface);
  return surface;
}

const SurfaceMesh Target = shapes::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));

TEST(FeatureCoverage, IsCompleteWhereAllEdgesAreMarked)
{
  const TargetFeatures features = findFeatures(Target, {});
  const FeatureCoverage coverage = featureCoverage(markedBox(), features, 0.05, 1e-9);
  EXPECT_NEAR(coverage.length, 24.0, 1e-12);
  EXPECT_EQ(coverage.missing, 0.0);
}

TEST(FeatureCoverage, IsNoneWithoutMarks)
{
  const TargetFeatures features = findFeatures(Target, {});
  const EditableSurface surface(shapes::triangleBox(8, Vec3(1, 1, 1)));
  const FeatureCoverage coverage = featureCoverage(surface, features, 0.05, 10.0);
  EXPECT_NEAR(coverage.missing, 24.0, 1e-12);
}

TEST(FeatureCoverage, MissesTheLengthOfEachEdgeWithoutAMark)
{
  const TargetFeatures features = findFeatures(Target, {});
  EditableSurface surface = markedBox();
  const Vec3 place(0.125, 1.0, 1.0);
  for (const Index e : editing::edgesOf(surface))
  {
    const Vec3 middle = 0.5 * (surface.point(surface.from(e)) + surface.point(surface.to(e)));
    if ((middle - place).norm() < 1e-12)
    {
      surface.setCurve(e, NoIndex);
    }
  }
  for (const double spacing : { 0.25, 0.05, 0.01 })
  {
    const FeatureCoverage coverage = featureCoverage(surface, features, spacing, 1e-9);
    EXPECT_NEAR(coverage.missing, 0.25, 1e-9) << spacing;
    EXPECT_LE((coverage.place - place).norm(), 0.125);
  }
  // The neighbours on the crease reach so far.
  const FeatureCoverage wide = featureCoverage(surface, features, 0.01, 0.05);
  EXPECT_NEAR(wide.missing, 0.15, 1e-9);
  EXPECT_EQ(featureCoverage(surface, features, 0.01, 0.126).missing, 0.0);
}

TEST(FeatureCoverage, ToleranceIsADistance)
{
  const TargetFeatures features = findFeatures(shapes::box(Vec3(-1, -1, -1), Vec3(1, 1, 1.1)), {});
  const EditableSurface surface = markedBox();
  // The top's four edges lie 0.1 above, and 0.1 of the four upright ones goes on above.
  EXPECT_EQ(featureCoverage(surface, features, 0.01, 0.11).missing, 0.0);
  EXPECT_NEAR(featureCoverage(surface, features, 0.01, 0.09).missing, 8.0 + 4 * 0.01, 1e-9);
}

TEST(FeatureCoverage, OfASmoothTargetIsNothing)
{
  const TargetFeatures features = findFeatures(shapes::sphere(3), {});
  const FeatureCoverage coverage = featureCoverage(markedBox(), features, 0.05, 1e-9);
  EXPECT_EQ(coverage.length, 0.0);
  EXPECT_EQ(coverage.missing, 0.0);
}

} // namespace
