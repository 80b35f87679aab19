// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ShrinkWrapOptions.h"

#include "Checks/Refusal.h"
#include "Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace evolving;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

std::string complaint(const std::function<void(ShrinkWrapOptions&)>& change)
{
  ShrinkWrapOptions options;
  change(options);
  return checks::refusalOf([&] { checkOptions(options); });
}

TEST(ShrinkWrapOptions, DefaultsPass)
{
  EXPECT_NO_THROW(checkOptions({}));
}

TEST(ShrinkWrapOptions, LengthsAreFiniteAndNotNegative)
{
  using Member = double ShrinkWrapOptions::*;
  for (const Member length : { &ShrinkWrapOptions::targetEdgeLength, &ShrinkWrapOptions::gapSize,
         &ShrinkWrapOptions::offsetDistance })
  {
    for (const double value : { -1e-300, -1.0, NaN, Infinity, -Infinity })
    {
      EXPECT_NE(
        complaint([&](auto& o) { o.*length = value; }).find("finite length"), std::string::npos);
    }
    EXPECT_EQ(complaint([&](auto& o) { o.*length = 1e-300; }), "");
    EXPECT_EQ(complaint([&](auto& o) { o.*length = 1e300; }), "");
  }
}

TEST(ShrinkWrapOptions, TheAngleIsBetweenNormalsAndStepsAreCounted)
{
  for (const double angle : { -0.1, 180.1, NaN })
  {
    EXPECT_NE(
      complaint([&](auto& o) { o.featureAngle = angle; }).find("FeatureAngle"), std::string::npos);
  }
  EXPECT_EQ(complaint([](auto& o) { o.featureAngle = 0.0; }), "");
  EXPECT_EQ(complaint([](auto& o) { o.featureAngle = 180.0; }), "");
  EXPECT_NE(
    complaint([](auto& o) { o.numberOfSteps = -1; }).find("NumberOfSteps"), std::string::npos);
  EXPECT_EQ(complaint([](auto& o) { o.numberOfSteps = 1; }), "");
}

TEST(ShrinkWrapOptions, TimeDoesNotDependOnTheNumberOfSteps)
{
  for (const WrapStart start : { WrapStart::Isosurface, WrapStart::Icosphere })
  {
    ShrinkWrapOptions options;
    options.start = start;
    const double time = stepsOf(options) * timeStepOf(options);
    EXPECT_GT(stepsOf(options), 0);
    options.numberOfSteps = 7;
    EXPECT_EQ(stepsOf(options), 7);
    EXPECT_NEAR(stepsOf(options) * timeStepOf(options), time, 1e-12);
  }
}

TEST(ShrinkWrapOptions, EveryOneOfThemCounts)
{
  const std::vector<std::function<void(ShrinkWrapOptions&)>> changes = {
    [](auto& o) { o.start = WrapStart::Icosphere; },
    [](auto& o) { o.sampleDimensions[2] = 64; },
    [](auto& o) { o.targetEdgeLength = 1.0; },
    [](auto& o) { o.gapSize = 1.0; },
    [](auto& o) { o.adaptToCurvature = true; },
    [](auto& o) { o.preserveFeatures = true; },
    [](auto& o) { o.featureAngle = 30.0; },
    [](auto& o) { o.numberOfSteps = 3; },
    [](auto& o) { o.offsetDistance = 1.0; },
  };
  for (const auto& change : changes)
  {
    ShrinkWrapOptions changed;
    change(changed);
    EXPECT_FALSE(changed == ShrinkWrapOptions());
    EXPECT_TRUE(changed == changed);
  }
}

} // namespace
