// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Shrink-wrapping with PreserveFeatures where there are none, or where none can be preserved.

#include "Checks/SurfaceMeasures.h"
#include "Remeshing/RemeshingShapes.h"
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
    const SurfaceMesh plain = wrap(target, quick(0.25));
    ShrinkWrapOptions options = quick(0.25);
    options.preserveFeatures = true;
    options.featureAngle = 180.0;
    EXPECT_TRUE(wrap(target, options) == plain);
  }
  // From 90 degrees on an edge of a box is no crease.
  ShrinkWrapOptions options = quick(0.25);
  options.preserveFeatures = true;
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
  options.preserveFeatures = false;
  const Wrapped plain(brick(), options);
  EXPECT_TRUE(plain.surface == wrapped.surface);
  EXPECT_FALSE(mentions(plain.sentences, "creases"));
}

TEST(WrapWithoutFeatures, AFoldedSheetHasNoCreasesAndSaysSo)
{
  const SurfaceMesh sheet = shapes::heightField(8, [](double x, double) { return std::abs(x); });
  const Wrapped wrapped(sheet, withFeatures(0.15));
  expectSound(wrapped.surface, 0, 1, 30.0);
  EXPECT_NEAR(wrapped.report.creases.length, 2.0, 1e-12);
  EXPECT_NEAR(wrapped.report.creases.missing, 2.0, 1e-9);
  EXPECT_TRUE(mentions(wrapped.sentences, "creases"));
}

} // namespace
