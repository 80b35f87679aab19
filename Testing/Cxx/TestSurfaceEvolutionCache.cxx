// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution: when it solves again, and what it keeps.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "EventLog.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkIcosphereSource.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfaceEvolution.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
void Prepare(vtkSurfaceEvolution* filter, int steps)
{
  filter->SetTimeStep(0.1);
  filter->SetNumberOfSteps(steps);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionCache, OneSolveWhateverTheOrderOfTimes)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(1));
  Prepare(filter, 6);
  std::vector<double> forwards;
  for (int k = 0; k <= 6; ++k)
  {
    filter->UpdateTimeStep(k * 0.1);
    forwards.push_back(DistanceFromOrigin(filter->GetOutput()).Largest);
  }
  for (const int k : { 6, 2, 5, 0, 3, 1, 4, 4 })
  {
    filter->UpdateTimeStep(k * 0.1);
    EXPECT_EQ(
      DistanceFromOrigin(filter->GetOutput()).Largest, forwards[static_cast<std::size_t>(k)]);
  }
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionCache, AnotherParameterIsAnotherSolve)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(1));
  Prepare(filter, 2);
  filter->Update();
  const double before = DistanceFromOrigin(filter->GetOutput()).Largest;
  filter->SetCurvatureSpeed(0.2);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 2);
  EXPECT_LT(DistanceFromOrigin(filter->GetOutput()).Largest, before);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionCache, TheSameContentIsNoNewSolve)
{
  vtkNew<vtkIcosphereSource> source;
  source->SetLevel(1);
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputConnection(source->GetOutputPort());
  Prepare(filter, 2);
  filter->Update();
  source->SetLevel(2);
  source->SetLevel(1);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
  source->SetRadius(2.0);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 2);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionCache, AMirroredSurfaceIsAnotherSolve)
{
  // The same digits with other signs, and an even number of them.
  const auto surface = Sample::Icosphere(1, 1.0, { 2.0, 0.0, 0.0 });
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(surface);
  Prepare(filter, 2);
  filter->Update();
  filter->SetInputData(Sample::Mapped(surface,
    [](const Sample::Point& p) {
      return Sample::Point{ -p[0], p[1], p[2] };
    }));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 2);
  EXPECT_LT(filter->GetOutput()->GetBounds()[1], 0.0);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionCache, AnotherImageIsAnotherSolve)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(0, Sample::Icosphere(1, 1.5));
  filter->SetInputData(1, Sample::SphereImage(9, 2.0, 1.0));
  Prepare(filter, 2);
  filter->Update();
  filter->SetInputData(1, Sample::SphereImage(9, 2.0, 1.0));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
  filter->SetInputData(1, Sample::SphereImage(9, 2.0, 0.9));
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 2);
  filter->SetInputData(1, nullptr);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 3);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionCache, ASmallCacheGivesTheSameStates)
{
  // A state has 642 points of about 160 bytes: a MiB holds ten of the 61.
  vtkNew<vtkSurfaceEvolution> roomy;
  vtkNew<vtkSurfaceEvolution> tight;
  for (vtkSurfaceEvolution* filter : { roomy.Get(), tight.Get() })
  {
    filter->SetInputData(Sample::Icosphere(3));
    Prepare(filter, 60);
    filter->SetTimeStep(0.01);
    filter->SetVolumeRedistribution(1.0);
  }
  tight->SetCacheLimit(1);
  for (const int k : { 60, 59, 33, 1, 7, 0 })
  {
    roomy->UpdateTimeStep(k * 0.01);
    tight->UpdateTimeStep(k * 0.01);
    EXPECT_EQ(FieldValue(tight->GetOutput(), "Iteration"), static_cast<double>(k));
    EXPECT_TRUE(SameSurface(roomy->GetOutput(), tight->GetOutput(), 1e-8)) << "step " << k;
  }
  EXPECT_EQ(tight->GetNumberOfSolves(), 1);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionCache, OnlyASmallCacheComputesAgain)
{
  const auto progressOfALookBack = [](int cacheLimit)
  {
    vtkNew<vtkSurfaceEvolution> filter;
    filter->SetInputData(Sample::Icosphere(3));
    Prepare(filter, 60);
    filter->SetTimeStep(0.01);
    filter->SetCacheLimit(cacheLimit);
    filter->Update();
    EventLog log(filter);
    filter->UpdateTimeStep(0.07);
    return log.Progress.size();
  };
  EXPECT_LE(progressOfALookBack(2048), 3u);
  EXPECT_GT(progressOfALookBack(1), 10u);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionCache, StatesShareTheirPolygons)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(1));
  Prepare(filter, 3);
  filter->UpdateTimeStep(0.0);
  vtkNew<vtkPolyData> start;
  start->ShallowCopy(filter->GetOutput());
  filter->UpdateTimeStep(0.3);
  EXPECT_EQ(start->GetPolys(), filter->GetOutput()->GetPolys());
  EXPECT_NE(start->GetPoints(), filter->GetOutput()->GetPoints());
}

} // namespace
