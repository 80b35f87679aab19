// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Shrink-wrapping with PreserveFeatures: targets of planes come out exactly.

#include "Checks/SurfaceMeasures.h"
#include "FeatureCapture/CaptureShapes.h"
#include "Mesh/MeshQuality.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "ShrinkWrap/FeatureWraps.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::wraps;

double volumeError(const SurfaceMesh& surface, const SurfaceMesh& target)
{
  return std::abs(signedVolume(surface) / signedVolume(target) - 1.0);
}

/// The edges at which a surface folds by more than 60 degrees, as segments.
SurfaceMesh foldsOf(const SurfaceMesh& mesh)
{
  EditableSurface surface(mesh);
  shapes::markCreases(surface);
  SurfaceMesh folds;
  for (const Index e : editing::edgesOf(surface))
  {
    if (surface.curve(e) != NoIndex && surface.isFirstHalf(e))
    {
      const Index a = folds.addPoint(surface.point(surface.from(e)));
      const Index b = folds.addPoint(surface.point(surface.to(e)));
      folds.addFace({ a, b, b });
    }
  }
  return folds;
}

double lengthOf(const SurfaceMesh& segments)
{
  double length = 0.0;
  for (Index f = 0; f < segments.faceCount(); ++f)
  {
    length += (segments.facePoint(f, 1) - segments.facePoint(f, 0)).norm();
  }
  return length;
}

/// The largest distance of the ends of some segments from others.
double farthestEnd(const SurfaceMesh& segments, const SurfaceMesh& others)
{
  const AABBTree tree(others);
  double squared = 0.0;
  for (const Vec3& end : segments.points)
  {
    squared = std::max(squared, tree.closest(end).at.squaredDistance);
  }
  return std::sqrt(squared);
}

TEST(WrapFeatures, ABoxIsExact)
{
  const Wrapped wrapped(brick(), withFeatures(0.2));
  expectSound(wrapped.surface, 0, 1, 40.0);
  EXPECT_LT(checks::hausdorff(wrapped.surface, brick(), 0.05), 1e-13);
  EXPECT_LT(volumeError(wrapped.surface, brick()), 1e-12);
  EXPECT_NEAR(wrapped.report.creases.length, 24.0, 1e-12);
  EXPECT_EQ(wrapped.report.creases.missing, 0.0);
  EXPECT_TRUE(wrapped.sentences.empty());
  const SurfaceMesh folds = foldsOf(wrapped.surface);
  EXPECT_NEAR(lengthOf(folds), 24.0, 1e-10);
  EXPECT_LT(farthestEnd(folds, foldsOf(brick())), 1e-13);
  for (const Vec3& corner : brick().points)
  {
    const auto& points = wrapped.surface.points;
    EXPECT_EQ(std::count(points.begin(), points.end(), corner), 1);
  }
}

TEST(WrapFeatures, ABoxIsExactOnAnyScaleAnywhere)
{
  const Vec3 away = 100.0 * std::sqrt(14.0) * Vec3(0.6, -0.48, 0.64);
  const auto expectExact = [](const SurfaceMesh& target, double scale, double rounding)
  {
    const Wrapped wrapped(target, withFeatures(0.2 * scale));
    expectSound(wrapped.surface, 0, 1, 40.0);
    EXPECT_LT(checks::hausdorff(wrapped.surface, target, 0.05 * scale), rounding * scale);
    EXPECT_NEAR(wrapped.report.creases.length, 24.0 * scale, 100.0 * rounding * scale);
    EXPECT_EQ(wrapped.report.creases.missing, 0.0);
    const Vec3 back = -target.points.front();
    EXPECT_LT(volumeError(shapes::transformed(wrapped.surface, 1.0, back),
                shapes::transformed(target, 1.0, back)),
      100.0 * rounding);
  };
  const SurfaceMesh rotated = shapes::mapped(brick(), shapes::someRotation());
  expectExact(rotated, 1.0, 1e-13);
  expectExact(shapes::transformed(rotated, 1e-4, Vec3::Zero()), 1e-4, 1e-13);
  expectExact(shapes::transformed(rotated, 1e4, Vec3::Zero()), 1e4, 1e-13);
  // Coordinates have 13 digits after the point there.
  expectExact(shapes::transformed(rotated, 1.0, away), 1.0, 1e-12);
}

TEST(WrapFeatures, AnEllIsExact)
{
  const Wrapped wrapped(shapes::ell(), withFeatures(0.15));
  expectSound(wrapped.surface, 0, 1, 40.0);
  EXPECT_LT(checks::hausdorff(wrapped.surface, shapes::ell(), 0.05), 1e-13);
  EXPECT_LT(volumeError(wrapped.surface, shapes::ell()), 1e-12);
  EXPECT_TRUE(wrapped.sentences.empty());
}

TEST(WrapFeatures, ACylinderHasItsRims)
{
  const SurfaceMesh cylinder = shapes::cylinder();
  for (const bool adapt : { false, true })
  {
    ShrinkWrapOptions options = withFeatures(0.15);
    options.adaptToCurvature = adapt;
    const Wrapped wrapped(cylinder, options);
    expectSound(wrapped.surface, 0, 1, 40.0);
    EXPECT_EQ(wrapped.report.creases.missing, 0.0);
    EXPECT_TRUE(wrapped.sentences.empty());
    const SurfaceMesh folds = foldsOf(wrapped.surface);
    EXPECT_LT(farthestEnd(folds, foldsOf(cylinder)), 1e-13);
    // Chords of 0.2 are shorter than the circle by 0.2^2 / 24, and none is missing.
    EXPECT_NEAR(lengthOf(folds), 2.0 * capture::rimLength(48), 0.03);
    // In the middle between two chords on a circle.
    EXPECT_LT(checks::hausdorff(wrapped.surface, cylinder, 0.05), 0.15 * 0.15 / 2.0);
    EXPECT_LT(volumeError(wrapped.surface, cylinder), 1e-3);
  }
}

TEST(WrapFeatures, CreasesAloneAttractNoSmallElements)
{
  // All that is curved is the tube: edges on its rims are no shorter than on it.
  ShrinkWrapOptions options = withFeatures(0.15);
  options.adaptToCurvature = true;
  const Wrapped cylinder(shapes::cylinder(), options);
  const SurfaceMesh folds = foldsOf(cylinder.surface);
  double onTube = 0.0;
  double count = 0.0;
  const EditableSurface surface(cylinder.surface);
  for (const Index e : editing::edgesOf(surface))
  {
    const Vec3 middle = 0.5 * (surface.point(surface.from(e)) + surface.point(surface.to(e)));
    if (middle.z() > 0.4 && middle.z() < 1.1)
    {
      onTube += surface.length(e);
      count += 1.0;
    }
  }
  EXPECT_GT(lengthOf(folds) / folds.faceCount(), 0.9 * onTube / count);
  // A box has nothing that is curved: elements of the largest size.
  options.targetEdgeLength = 0.2;
  const Wrapped adapted(brick(), options);
  options.adaptToCurvature = false;
  const Wrapped uniform(brick(), options);
  EXPECT_LT(adapted.surface.vertexCount(), 0.6 * uniform.surface.vertexCount());
  EXPECT_LT(checks::hausdorff(adapted.surface, brick(), 0.05), 1e-13);
}

TEST(WrapFeatures, ADartIsThere)
{
  const SurfaceMesh target = shapes::boxWithDart();
  const Wrapped wrapped(target, withFeatures(0.15));
  expectSound(wrapped.surface, 0);
  EXPECT_EQ(wrapped.report.creases.missing, 0.0) << wrapped.report.creases.place.transpose();
  EXPECT_TRUE(wrapped.sentences.empty());
  const auto& points = wrapped.surface.points;
  EXPECT_EQ(std::count(points.begin(), points.end(), Vec3(0, 0, 0)), 1);
  EXPECT_EQ(std::count(points.begin(), points.end(), Vec3(-1, 0, 0)), 1);
  // Without it edges cut across the ridge.
  const AABBTree result(wrapped.surface);
  ShrinkWrapOptions without = withFeatures(0.15);
  without.preserveFeatures = FeaturePreservation::Off;
  const AABBTree plain(wrap(target, without));
  double farthest = 0.0;
  double farthestPlain = 0.0;
  for (double t = 0.0; t <= 1.0; t += 0.02)
  {
    const Vec3 ridge(-t, 0, 0);
    farthest = std::max(farthest, std::sqrt(result.closest(ridge).at.squaredDistance));
    farthestPlain = std::max(farthestPlain, std::sqrt(plain.closest(ridge).at.squaredDistance));
  }
  EXPECT_LT(farthest, 1e-13);
  EXPECT_GT(farthestPlain, 0.01);
}

TEST(WrapFeatures, FeetOfRibsAreThereWhateverTheGrid)
{
  // Flush with the plate's side: three creases and an end that goes on as the plate's own.
  std::vector<Vec3> comb = { { 0, 0, 0 }, { 10, 0, 0 }, { 10, 2, 0 } };
  for (const double x : { 8.0, 5.0, 2.0 })
  {
    comb.insert(comb.end(), { { x + 1, 2, 0 }, { x + 1, 5, 0 }, { x, 5, 0 }, { x, 2, 0 } });
  }
  comb.insert(comb.end(), { { 0, 2, 0 } });
  const SurfaceMesh target = shapes::extruded(comb, 6.0);
  for (const int samples : { 48, 56, 64, 72, 73, 88 })
  {
    ShrinkWrapOptions options = withFeatures(0.5);
    options.sampleDimensions = { samples, samples, samples };
    options.preserveFeatures = FeaturePreservation::Automatic;
    const Wrapped wrapped(target, options);
    expectSound(wrapped.surface, 0);
    EXPECT_EQ(wrapped.report.creases.missing, 0.0)
      << samples << ", at " << wrapped.report.creases.place.transpose();
    EXPECT_NEAR(signedVolume(wrapped.surface), 6.0 * (10.0 * 2.0 + 3.0 * 1.0 * 3.0), 1e-9);
    EXPECT_GT(smallestAngle(wrapped.surface), 33.0) << samples;
  }
}

TEST(WrapFeatures, WhatElementsCannotCarryIsSaid)
{
  // A plate thinner than an element: both creases of its rim have no room side by side.
  const SurfaceMesh plate = shapes::box(Vec3(0, 0, 0), Vec3(3, 3, 0.25));
  const Wrapped coarse(plate, withFeatures(0.4));
  EXPECT_GT(coarse.report.creases.leftOut.length, 11.0);
  ASSERT_FALSE(coarse.sentences.empty());
  const std::string& last = coarse.sentences.back();
  EXPECT_NE(last.find("can carry"), std::string::npos) << last;
  EXPECT_NE(last.find("smaller TargetEdgeLength"), std::string::npos) << last;
  const Wrapped fine(plate, withFeatures(0.15));
  EXPECT_EQ(fine.report.creases.leftOut.length, 0.0);
  EXPECT_TRUE(fine.sentences.empty());
}

} // namespace
