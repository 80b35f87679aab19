// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkShrinkWrap: one closed surface on any input, and what its field data say of it.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Wrapped(
  vtkPolyData* input, const std::function<void(vtkShrinkWrap*)>& setUp = [](vtkShrinkWrap*) {})
{
  vtkNew<vtkShrinkWrap> filter;
  EventLog log(filter);
  SetUpCoarsely(filter, input);
  setUp(filter);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty()) << log.Errors.front();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
TEST(ShrinkWrap, TheBunnyIsWrapped)
{
  const auto bunny = Sample::Read("bunny.ply");
  const auto output = Wrapped(bunny,
    [](vtkShrinkWrap* filter)
    {
      filter->SetSampleDimensions(64, 64, 64);
      filter->SetNumberOfSteps(50);
    });
  ExpectClosed(output, 0);
  EXPECT_EQ(FieldValue(output, "SelfIntersections"), 0.0);
  EXPECT_GT(output->GetNumberOfPoints(), 500);
  EXPECT_NEAR(FieldValue(output, "MaxDistance"), LargestDistance(output, bunny), 1e-5);
  EXPECT_NEAR(FieldValue(output, "MinAngle"), SmallestAngleOf(output), 1e-3);
  EXPECT_NEAR(VolumeOf(output), VolumeOf(bunny), 0.05 * VolumeOf(bunny));
}

//------------------------------------------------------------------------------
TEST(ShrinkWrap, DefaultsGiveAboutNineThousandPointsOnAnyScale)
{
  for (const double scale : { 1e-3, 1e3 })
  {
    vtkNew<vtkShrinkWrap> filter;
    const auto sphere = Sample::Icosphere(3, scale);
    filter->SetInputData(sphere);
    filter->SetSampleDimensions(64, 64, 64);
    filter->SetNumberOfSteps(20);
    filter->Update();
    const vtkIdType points = filter->GetOutput()->GetNumberOfPoints();
    EXPECT_GT(points, 6000);
    EXPECT_LT(points, 14000);
    EXPECT_LT(LargestDistance(filter->GetOutput(), sphere), 0.02 * scale);
  }
}

//------------------------------------------------------------------------------
TEST(ShrinkWrap, HandlesAreKept)
{
  ExpectClosed(Wrapped(Sample::Read("torus.ply")), 1);
  ExpectClosed(Wrapped(Sample::Read("genus_two.obj")), 2);
}

//------------------------------------------------------------------------------
TEST(ShrinkWrap, AnIcosphereStartWrapsAConvexInput)
{
  const auto output =
    Wrapped(Sample::Box(4), [](vtkShrinkWrap* filter) { filter->SetStartToIcosphere(); });
  ExpectClosed(output, 0);
  EXPECT_NEAR(VolumeOf(output), 8.0, 0.8);
}

//------------------------------------------------------------------------------
TEST(ShrinkWrap, AMembraneIsNotPassedOverInSilence)
{
  vtkNew<vtkShrinkWrap> filter;
  EventLog log(filter);
  SetUpCoarsely(filter, Sample::Read("torus.ply"));
  filter->SetStartToIcosphere();
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  // Its hole is closed, and the membrane over it is far from where it should be.
  for (const char* word : { "genus 1 in 1 part, the result genus 0", "membrane" })
  {
    EXPECT_TRUE(std::any_of(log.Warnings.begin(), log.Warnings.end(),
      [word](const std::string& warning) { return warning.find(word) != std::string::npos; }))
      << word;
  }
  ExpectClosed(filter->GetOutput(), 0);
}

//------------------------------------------------------------------------------
TEST(ShrinkWrap, TheOffsetIsADistance)
{
  const auto output =
    Wrapped(Sample::Icosphere(3), [](vtkShrinkWrap* filter) { filter->SetOffsetDistance(0.5); });
  ExpectClosed(output, 0);
  const Range radius = DistanceFromOrigin(output);
  EXPECT_NEAR(radius.Smallest, 1.5, 0.05);
  EXPECT_NEAR(radius.Largest, 1.5, 0.05);
  EXPECT_LT(FieldValue(output, "MaxDistance"), 0.05);
}

//------------------------------------------------------------------------------
TEST(ShrinkWrap, PointsAloneAreWrapped)
{
  const auto sphere = Sample::Icosphere(4);
  const auto output = Wrapped(Sample::PointsOf(sphere),
    [](vtkShrinkWrap* filter)
    {
      filter->SetTargetEdgeLength(0.12);
      filter->SetGapSize(0.25);
    });
  ExpectClosed(output, 0);
  const Range radius = DistanceFromOrigin(output);
  EXPECT_GT(radius.Smallest, 0.9);
  EXPECT_LT(radius.Largest, 1.2);
}

//------------------------------------------------------------------------------
TEST(ShrinkWrap, AnOpenSheetIsWrappedOnBothSides)
{
  const auto sheet = Sample::Sheet(8);
  const auto output = Wrapped(sheet);
  ExpectClosed(output, 0);
  EXPECT_GT(AreaOf(output), 1.8 * AreaOf(sheet));
  EXPECT_LT(LargestDistance(output, sheet), 0.3);
}

//------------------------------------------------------------------------------
using DirtyInput = std::pair<const char*, Sample::Surface (*)()>;

class ShrinkWrapDirty : public testing::TestWithParam<DirtyInput>
{
};

TEST_P(ShrinkWrapDirty, IsClosedAndNearTheInput)
{
  const auto input = GetParam().second();
  const auto output = Wrapped(input);
  ExpectClosed(output, 0);
  EXPECT_NEAR(VolumeOf(output), 4.19, 0.4);
}

/// A sphere with a small hole: the 40 triangles left out are narrower than the gap.
Sample::Surface Punctured()
{
  return Sample::KeepPolygons(Sample::Icosphere(4), [](vtkIdType number) { return number > 5; });
}

Sample::Surface WithDuplicates()
{
  const auto sphere = Sample::Icosphere(3);
  return Sample::Together(sphere, sphere);
}

/// A small sphere inside is swallowed.
Sample::Surface WithShellInside()
{
  return Sample::Together(Sample::Icosphere(3), Sample::Icosphere(2, 0.5));
}

Sample::Surface WithSheetAcross()
{
  const auto sheet = Sample::Mapped(Sample::Sheet(4),
    [](const Sample::Point& p) -> Sample::Point {
      return { 0.6 * p[0], 0.6 * p[1], 0.1 };
    });
  return Sample::Together(Sample::Icosphere(3), sheet);
}

INSTANTIATE_TEST_SUITE_P(Inputs, ShrinkWrapDirty,
  testing::Values(DirtyInput{ "Soup", []() { return Sample::Soup(Sample::Icosphere(3)); } },
    DirtyInput{
      "MixedOrientation", []() { return Sample::WithMixedOrientation(Sample::Icosphere(3)); } },
    DirtyInput{ "Punctured", Punctured }, DirtyInput{ "Duplicates", WithDuplicates },
    DirtyInput{ "ShellInside", WithShellInside }, DirtyInput{ "SheetAcross", WithSheetAcross }),
  [](const testing::TestParamInfo<DirtyInput>& input) { return input.param.first; });

} // namespace
