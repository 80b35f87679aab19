// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FlowOptions.h"

#include "ChangedMembers.h"
#include "Errors.h"
#include "Redistribution/SubSteps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace evolving;

TEST(FlowOptions, DefaultsAreAccepted)
{
  EXPECT_NO_THROW(checkOptions(FlowOptions()));
}

TEST(FlowOptions, ValuesOutOfRangeAreRefused)
{
  const std::vector<std::function<void(FlowOptions&)>> mistakes = {
    [](FlowOptions& o) { o.timeStep = -1.0; },
    [](FlowOptions& o) { o.timeStep = std::nan(""); },
    [](FlowOptions& o) { o.timeStep = INFINITY; },
    [](FlowOptions& o) { o.numberOfSteps = -1; },
    [](FlowOptions& o) { o.curvatureSpeed = -0.1; },
    [](FlowOptions& o) { o.curvatureRange = 0.0; },
    [](FlowOptions& o) { o.advectionSpeed = -1.0; },
    [](FlowOptions& o) { o.advectionBalance = 1.01; },
    [](FlowOptions& o) { o.edgeSharpness = std::nan(""); },
    [](FlowOptions& o) { o.smoothingSteps = -3; },
    [](FlowOptions& o) { o.smoothingSpeed = -1.0; },
    [](FlowOptions& o) { o.smoothingDecay = -1.0; },
    [](FlowOptions& o) { o.surfaceGuard = 0.5; },
    [](FlowOptions& o) { o.convergenceTolerance = -1.0; },
    [](FlowOptions& o) { o.stallSteps = -1; },
    [](FlowOptions& o) { o.longestAdvection = -1.0; },
    [](FlowOptions& o) { o.remeshingInterval = 0; },
    [](FlowOptions& o) { o.solverTolerance = 0.0; },
    [](FlowOptions& o) { o.solverTolerance = 0.5; },
    [](FlowOptions& o) { o.redistribution.volume = -1.0; },
    [](FlowOptions& o) { o.redistribution.angle = INFINITY; },
    [](FlowOptions& o) { o.redistribution.length = std::nan(""); },
  };
  for (std::size_t i = 0; i < mistakes.size(); ++i)
  {
    FlowOptions options;
    mistakes[i](options);
    EXPECT_THROW(checkOptions(options), InputError) << "mistake " << i;
  }
}

TEST(FlowOptions, EqualOnlyWhenEverythingIs)
{
  expectEveryMemberCounts(FlowOptions());
  expectEveryMemberCounts(RedistributionOptions());
}

TEST(FlowOptions, RelativeUnitsScaleByTheSize)
{
  FlowOptions options;
  options.curvatureSpeed = 2.0;
  options.curvatureRange = 3.0;
  options.smoothingSpeed = 0.1;
  options.advectionSpeed = 5.0;
  options.redistribution.curvatureControlAlpha = 0.5;
  const FlowOptions absolute = inAbsoluteUnits(options, 10.0);
  EXPECT_EQ(absolute.curvatureSpeed, 200.0);
  EXPECT_EQ(absolute.curvatureRange, 300.0);
  EXPECT_EQ(absolute.smoothingSpeed, 10.0);
  EXPECT_EQ(absolute.advectionSpeed, 5.0);
  EXPECT_EQ(absolute.redistribution.curvatureControlAlpha, 5.0);
  EXPECT_FALSE(absolute.relativeUnits);
  EXPECT_TRUE(inAbsoluteUnits(absolute, 10.0) == absolute);
  options.flow = Flow::SurfaceDiffusion;
  EXPECT_EQ(inAbsoluteUnits(options, 10.0).curvatureSpeed, 20000.0);
}

TEST(SubSteps, DivideAsTheExplicitPartsNeed)
{
  RedistributionOptions rates;
  EXPECT_EQ(divideStep(100.0, rates, 0.0).count, 1);
  rates.volume = 100.0;
  EXPECT_EQ(divideStep(0.01, rates, 0.0).count, 1);
  EXPECT_EQ(divideStep(0.025, rates, 0.0).count, 3);
  rates.angle = 100.0;
  EXPECT_EQ(divideStep(0.003, rates, 0.0).count, 1);
  EXPECT_EQ(divideStep(0.004, rates, 0.0).count, 2);
  rates.angleMethod = AngleMethod::Shape;
  EXPECT_EQ(divideStep(0.004, rates, 0.0).count, 1);
  EXPECT_EQ(divideStep(0.0081, rates, 0.0).count, 2);
  EXPECT_EQ(divideStep(0.1, RedistributionOptions(), 35.0).count, 4);
  EXPECT_NEAR(divideStep(0.1, RedistributionOptions(), 35.0).timeStep, 0.025, 1e-15);
}

TEST(SubSteps, AreBoundedAndThenRatesGiveWay)
{
  RedistributionOptions rates;
  rates.volume = 1e9;
  rates.angle = 1e9;
  rates.length = 3.0;
  const SubSteps parts = divideStep(0.01, rates, 0.0);
  EXPECT_EQ(parts.count, MostSubSteps);
  const RedistributionOptions limited = limitRates(rates, parts.timeStep);
  EXPECT_NEAR(limited.volume * parts.timeStep, 1.0, 1e-12);
  EXPECT_NEAR(limited.angle * parts.timeStep, 0.3, 1e-12);
  EXPECT_EQ(limited.length, 3.0);
}
