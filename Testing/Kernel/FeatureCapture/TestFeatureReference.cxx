// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/FeatureReference.h"

#include "FeatureCapture/CaptureMeasures.h"
#include "FeatureCapture/CaptureShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace evolving;

using namespace evolving::shapes;
using capture::squaredDistanceToCurve;
using capture::squaredDistanceToPatch;

/// Says that it was asked.
class Elsewhere : public ReferenceSurface
{
public:
  Foot onSurface(const Vec3& point, const Vec3& facing, Index label, Index guess) const override
  {
    EXPECT_EQ(label, FeatureReference::NoPatch);
    return { point + Vec3(7, 8, 9), -facing, guess + 1 };
  }
};

constexpr double Far = 100.0;

TEST(FeatureReference, FeetLieOnTheirPatchAsAllTrianglesSay)
{
  std::mt19937 generator(8);
  for (const capture::Shape& shape : capture::creasedShapes())
  {
    const TargetFeatures features = featuresOf(shape);
    const Elsewhere elsewhere;
    const FeatureReference reference(elsewhere, features, Far);
    Index guess = NoIndex;
    for (int k = 0; k < 60; ++k)
    {
      const Vec3 point = 2.0 * randomPoint(generator);
      const Vec3 facing = randomPoint(generator).normalized();
      for (Index patch = 0; patch < features.patchCount(); ++patch)
      {
        // The last guess, which is of another patch, must do no harm.
        const ReferenceSurface::Foot foot = reference.onSurface(point, facing, patch, guess);
        guess = foot.triangle;
        const double squared = squaredDistanceToPatch(features, patch, point);
        ASSERT_NEAR((foot.point - point).squaredNorm(), squared, 1e-12) << shape.name;
        ASSERT_NEAR(squaredDistanceToPatch(features, patch, foot.point), 0.0, 1e-24);
        ASSERT_NEAR(foot.normal.norm(), 1.0, 1e-14);
        ASSERT_GE(foot.normal.dot(facing), 0.0);
      }
    }
  }
}

TEST(FeatureReference, NormalsAreThoseOfThePatchOnTheSideAskedFor)
{
  const TargetFeatures features = findFeatures(shapes::box(Vec3(0, 0, 0), Vec3(1, 2, 3)), {});
  const Elsewhere elsewhere;
  const FeatureReference reference(elsewhere, features, Far);
  const Index top = features.patchOf(features.closestPoint(Vec3(0.5, 1.0, 3.5)).triangle);
  for (const double side : { -1.0, 1.0 })
  {
    // Closest to another patch by far.
    const auto foot = reference.onSurface(Vec3(0.5, 1, -2), Vec3(0.6, 0, 0.8 * side), top, NoIndex);
    EXPECT_NEAR((foot.point - Vec3(0.5, 1, 3)).norm(), 0.0, 1e-14);
    EXPECT_NEAR((foot.normal - Vec3(0, 0, side)).norm(), 0.0, 1e-14);
  }
}

TEST(FeatureReference, WithoutAPatchTheOtherReferenceIsAsked)
{
  const TargetFeatures features = findFeatures(shapes::box(Vec3(0, 0, 0), Vec3(1, 2, 3)), {});
  const Elsewhere elsewhere;
  const FeatureReference reference(elsewhere, features, Far);
  const auto foot =
    reference.onSurface(Vec3(1, 2, 3), Vec3::UnitX(), FeatureReference::NoPatch, 41);
  EXPECT_EQ(foot.point, Vec3(8, 10, 12));
  EXPECT_EQ(foot.normal, Vec3(-1, 0, 0));
  EXPECT_EQ(foot.triangle, 42);
}

TEST(FeatureReference, NothingIsBeyondItsReach)
{
  const TargetFeatures features = findFeatures(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), {});
  const Elsewhere elsewhere;
  const FeatureReference reference(elsewhere, features, 0.25);
  const Index top = features.patchOf(features.closestPoint(Vec3(0.5, 0.5, 2.0)).triangle);
  for (const double height : { 1.249, 1.251, 0.751, 0.749, -3.0 })
  {
    const Vec3 point(0.4, 0.3, height);
    const auto foot = reference.onSurface(point, Vec3(0.6, 0, 0.8), top, 5);
    const bool isNear = std::abs(height - 1.0) < 0.25;
    EXPECT_NEAR((foot.point - (isNear ? Vec3(0.4, 0.3, 1) : point)).norm(), 0.0, 1e-14);
    EXPECT_EQ(foot.normal, isNear ? Vec3(0, 0, 1) : Vec3(0.6, 0, 0.8));
  }
}

TEST(FeatureReference, PointsOfCurvesAreThoseOfAllTheirEdges)
{
  std::mt19937 generator(9);
  for (const capture::Shape& shape : capture::creasedShapes())
  {
    const TargetFeatures features = featuresOf(shape);
    const Elsewhere elsewhere;
    const FeatureReference reference(elsewhere, features, 1e-3); // of no account for curves
    for (int k = 0; k < 60; ++k)
    {
      const Vec3 point = 2.0 * randomPoint(generator);
      for (Index curve = 0; curve < static_cast<Index>(shape.curves); ++curve)
      {
        const Vec3 onCurve = reference.onCurve(point, curve);
        const double squared = squaredDistanceToCurve(features, curve, point);
        ASSERT_NEAR((onCurve - point).squaredNorm(), squared, 1e-12) << shape.name;
        ASSERT_NEAR(squaredDistanceToCurve(features, curve, onCurve), 0.0, 1e-24);
      }
    }
  }
}

} // namespace
