// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkShrinkWrap: PreserveFeatures and FeatureAngle.

#include "DataChecks.h"
#include "EventLog.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// Coordinates of about 1 as float.
constexpr double Rounding = 1e-6;

//------------------------------------------------------------------------------
/// The box from -1 to 1, with elements of a size that its sides have room for.
void SetUpOnBox(vtkShrinkWrap* filter)
{
  filter->SetInputData(Sample::Box(4));
  filter->SetSampleDimensions(40, 40, 40);
  filter->SetTargetEdgeLength(0.2);
  filter->SetNumberOfSteps(30);
  filter->SetPreserveFeaturesToOn();
}

//------------------------------------------------------------------------------
TEST(ShrinkWrapFeatures, ArePreservedOfABoxUnlessOff)
{
  vtkNew<vtkShrinkWrap> filter;
  EXPECT_EQ(filter->GetPreserveFeatures(), vtkShrinkWrap::AUTOMATIC);
  filter->SetPreserveFeatures(7);
  EXPECT_EQ(filter->GetPreserveFeatures(), vtkShrinkWrap::AUTOMATIC);
  filter->SetPreserveFeatures(-1);
  EXPECT_EQ(filter->GetPreserveFeatures(), vtkShrinkWrap::OFF);
  filter->SetPreserveFeaturesToOn();
  EXPECT_EQ(filter->GetPreserveFeatures(), vtkShrinkWrap::ON);
  EXPECT_EQ(filter->GetFeatureAngle(), 45.0);
  filter->SetFeatureAngle(-1.0);
  EXPECT_EQ(filter->GetFeatureAngle(), 0.0);
  filter->SetFeatureAngle(181.0);
  EXPECT_EQ(filter->GetFeatureAngle(), 180.0);
  SetUpOnBox(filter);
  filter->SetPreserveFeaturesToOff();
  filter->Update();
  EXPECT_GT(LargestDistance(Sample::Box(4), filter->GetOutput()), 0.02);
  filter->SetFeatureAngle(45.0);
  filter->SetPreserveFeaturesToAutomatic();
  filter->Update();
  EXPECT_LT(LargestDistance(Sample::Box(4), filter->GetOutput()), Rounding);
}

//------------------------------------------------------------------------------
TEST(ShrinkWrapFeatures, OfABoxAreExact)
{
  vtkNew<vtkShrinkWrap> filter;
  EventLog log(filter);
  SetUpOnBox(filter);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_TRUE(log.Warnings.empty());
  EXPECT_LT(LargestDistance(output, Sample::Box(4)), Rounding);
  EXPECT_LT(LargestDistance(Sample::Box(4), output), Rounding);
  EXPECT_NEAR(VolumeOf(output), 8.0, 8.0 * Rounding);
  EXPECT_NEAR(AreaOf(output), 24.0, 24.0 * Rounding);
  EXPECT_GT(FieldValue(output, "MinAngle"), 40.0);
  EXPECT_EQ(FieldValue(output, "SelfIntersections"), 0.0);
  EXPECT_EQ(CountBadEdges(output), 0);
}

//------------------------------------------------------------------------------
TEST(ShrinkWrapFeatures, AreThoseBeyondTheAngle)
{
  vtkNew<vtkShrinkWrap> filter;
  SetUpOnBox(filter);
  filter->SetFeatureAngle(89.0);
  filter->Update();
  EXPECT_LT(LargestDistance(Sample::Box(4), filter->GetOutput()), Rounding);
  filter->SetFeatureAngle(91.0);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 2);
  EXPECT_GT(LargestDistance(Sample::Box(4), filter->GetOutput()), 0.02);
  filter->SetFeatureAngle(45.0);
  filter->SetPreserveFeaturesToAutomatic();
  filter->Update();
  EXPECT_LT(LargestDistance(Sample::Box(4), filter->GetOutput()), Rounding);
}

//------------------------------------------------------------------------------
TEST(ShrinkWrapFeatures, ThatAreMissingAreWarnedOf)
{
  vtkNew<vtkShrinkWrap> filter;
  EventLog log(filter);
  SetUpOnBox(filter);
  filter->SetOffsetDistance(0.1);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  ASSERT_EQ(log.Warnings.size(), 1u);
  EXPECT_NE(log.Warnings.front().find("creases, 24 long in all, 24"), std::string::npos)
    << log.Warnings.front();
  EXPECT_EQ(CountBadEdges(filter->GetOutput()), 0);
}

} // namespace
