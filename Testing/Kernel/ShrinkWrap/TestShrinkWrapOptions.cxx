// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ShrinkWrapOptions.h"

#include "ChangedMembers.h"
#include "Checks/Refusal.h"
#include "Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

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
  EXPECT_NO_THROW(checkOptions(ShrinkWrapOptions()));
}

TEST(ShrinkWrapOptions, LengthsAreFiniteAndNotNegative)
{
  using Member = double ShrinkWrapOptions::*;
  const std::pair<Member, std::string> lengths[] = {
    { &ShrinkWrapOptions::targetEdgeLength, "TargetEdgeLength" },
    { &ShrinkWrapOptions::gapSize, "GapSize" },
    { &ShrinkWrapOptions::offsetDistance, "OffsetDistance" },
  };
  for (const auto& [length, name] : lengths)
  {
    const Member member = length;
    for (const double value : { -1e-300, -1.0, NaN, Infinity, -Infinity, 1e32, 1e300 })
    {
      EXPECT_EQ(complaint([&](auto& o) { o.*member = value; }).find(name + " is "), 0u);
    }
    EXPECT_EQ(complaint([&](auto& o) { o.*member = 1e-31; }), "");
    EXPECT_EQ(complaint([&](auto& o) { o.*member = 1e31; }), "");
    EXPECT_EQ(complaint([&](auto& o) { o.*member = 0.0; }), "");
  }
  // No smaller triangle is one in single precision, while no gap is smaller than 0.
  EXPECT_NE(complaint([](auto& o) { o.targetEdgeLength = 1e-300; }), "");
  EXPECT_EQ(complaint([](auto& o) { o.gapSize = 1e-300; }), "");
  EXPECT_EQ(complaint([](auto& o) { o.offsetDistance = 1e-300; }), "");
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
  expectEveryMemberCounts(ShrinkWrapOptions());
}

} // namespace
