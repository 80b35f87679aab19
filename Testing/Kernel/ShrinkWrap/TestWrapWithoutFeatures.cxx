// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Shrink-wrapping with PreserveFeatures where there are none, or where none can be preserved.

#include "Checks/SurfaceMeasures.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "ShrinkWrap/FeatureWraps.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::wraps;

bool mentions(const std::vector<std::string>& sentences, const char* word)
{
  return std::any_of(sentences.begin(), sentences.end(),
    [word](const std::string& sentence) { return sentence.find(word) != std::string::npos; });
}

TEST(WrapWithoutFeatures, WithoutCreasesBitsAreThoseOfAPlainWrap)
{
  for (const SurfaceMesh& target : { brick(), icosphere(3) })
  {
    ShrinkWrapOptions options = quick(0.25);
    options.preserveFeatures = FeaturePreservation::Off;
    const SurfaceMesh plain = wrap(target, options);
    options.preserveFeatures = FeaturePreservation::On;
    options.featureAngle = 180.0;
    EXPECT_TRUE(wrap(target, options) == plain);
  }
  // From 90 degrees on an edge of a box is no crease.
  ShrinkWrapOptions options = quick(0.25);
  options.preserveFeatures = FeaturePreservation::On;
  options.featureAngle = 89.0;
  EXPECT_LT(checks::hausdorff(wrap(brick(), options), brick(), 0.05), 1e-13);
  options.featureAngle = 91.0;
  EXPECT_GT(checks::hausdorff(wrap(brick(), options), brick(), 0.05), 0.01);
}

TEST(WrapWithoutFeatures, AnOffsetHasNoCreasesAndSaysSo)
{
  ShrinkWrapOptions options = withFeatures(0.2);
  options.offsetDistance = 0.1;
  const Wrapped wrapped(brick(), options);
  expectSound(wrapped.surface, 0);
  EXPECT_LT(wrapped.report.maxDistance, 0.01);
  EXPECT_NEAR(wrapped.report.creases.missing, 24.0, 1e-9);
  EXPECT_TRUE(mentions(wrapped.sentences, "creases"));
  options.preserveFeatures = FeaturePreservation::Off;
  const Wrapped plain(brick(), options);
  EXPECT_TRUE(plain.surface == wrapped.surface);
  EXPECT_FALSE(mentions(plain.sentences, "creases"));
}

TEST(WrapWithoutFeatures, AFoldedSheetOfUniformElementsHasNoCreasesAndSaysSo)
{
  const SurfaceMesh sheet = shapes::heightField(8, [](double x, double) { return std::abs(x); });
  const Wrapped wrapped(sheet, withFeatures(0.15));
  expectSound(wrapped.surface, 0, 1, 30.0);
  EXPECT_NEAR(wrapped.report.creases.length, 2.0, 1e-12);
  EXPECT_NEAR(wrapped.report.creases.missing, 2.0, 1e-9);
  EXPECT_TRUE(mentions(wrapped.sentences, "creases"));
}

TEST(WrapWithoutFeatures, AFoldedSheetIsElseASolidWithAllItsCreases)
{
  const SurfaceMesh sheet = shapes::heightField(8, [](double x, double) { return std::abs(x); });
  ShrinkWrapOptions options = withFeatures(0.0);
  options.targetNumberOfPoints = 2000;
  const Wrapped wrapped(sheet, options);
  expectSound(wrapped.surface, 0, 1, 30.0);
  // The fold and the rim, on both sides.
  EXPECT_GT(wrapped.report.creases.length, 2.0 * (2.0 + 4.0 + 4.0 * std::sqrt(2.0)) - 0.5);
  EXPECT_EQ(wrapped.report.creases.missing, 0.0);
  EXPECT_FALSE(mentions(wrapped.sentences, "creases"));
}

TEST(WrapWithoutFeatures, AutomaticLeavesRoughThingsAsTheyAre)
{
  const SurfaceMesh rough = shapes::shaken(icosphere(3), 0.03, 1);
  ShrinkWrapOptions options = quick(0.15, 48);
  options.preserveFeatures = FeaturePreservation::Off;
  const SurfaceMesh plain = wrap(rough, options);
  options.preserveFeatures = FeaturePreservation::Automatic;
  EXPECT_TRUE(wrap(rough, options) == plain);
  options.preserveFeatures = FeaturePreservation::On;
  EXPECT_FALSE(wrap(rough, options) == plain);
}

TEST(WrapWithoutFeatures, AutomaticIsOnForABox)
{
  ShrinkWrapOptions options = withFeatures(0.25);
  const SurfaceMesh on = wrap(brick(), options);
  options.preserveFeatures = FeaturePreservation::Automatic;
  EXPECT_TRUE(wrap(brick(), options) == on);
}

TEST(WrapWithoutFeatures, ASheetBesideABoxCostsTheBoxNothing)
{
  const SurfaceMesh sheet = shapes::transformed(shapes::sheet(6, true), 2.0, Vec3(4.0, 0.0, 1.0));
  const Wrapped wrapped(shapes::merged(brick(), sheet), withFeatures(0.2));
  expectSound(wrapped.surface, 0, 2, 30.0);
  EXPECT_NEAR(wrapped.report.creases.length, 24.0, 1e-9);
  EXPECT_EQ(wrapped.report.creases.missing, 0.0);
  // Welded, it has no points of the wall any more.
  const SurfaceMesh ofBox = weldCoincidentPoints(
    shapes::facesWhere(wrapped.surface, [](const Vec3& middle) { return middle.x() < 2.0; }));
  EXPECT_LT(checks::hausdorff(ofBox, brick(), 0.05), 1e-12);
}

} // namespace
