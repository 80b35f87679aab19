// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution in a pipeline: which times it has, which it gives, how often it solves.

#include "DataChecks.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"
#include "TemporalSphere.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
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
  filter->SetCurvatureSpeed(0.01); // far from a point
}

//------------------------------------------------------------------------------
double IterationAt(vtkSurfaceEvolution* filter, double time)
{
  filter->UpdateTimeStep(time);
  return FieldValue(filter->GetOutput(), "Iteration");
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionTime, StepsFollowFromParametersAlone)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(0));
  Prepare(filter, 7);
  filter->SetOutputInterval(3);
  EXPECT_EQ(TimesOf(filter), std::vector<double>({ 0.0, 3 * 0.1, 6 * 0.1, 7 * 0.1 }));
  filter->SetSmoothingSteps(4);
  EXPECT_EQ(
    TimesOf(filter), std::vector<double>({ 0.0, 3 * 0.1, 6 * 0.1, 7 * 0.1, 10 * 0.1, 11 * 0.1 }));
  const double* range = filter->GetOutputInformation(0)->Get(Pipeline::TIME_RANGE());
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 11 * 0.1);
  EXPECT_EQ(filter->GetNumberOfSolves(), 0);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionTime, TheHistoryHasNoTime)
{
  vtkNew<TemporalSphere> source;
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputConnection(source->GetOutputPort());
  Prepare(filter, 2);
  EXPECT_EQ(TimesOf(filter, 0), std::vector<double>({ 0.0, 0.1, 0.2 }));
  EXPECT_TRUE(TimesOf(filter, 1).empty());
  EXPECT_FALSE(filter->GetOutputInformation(1)->Has(Pipeline::TIME_RANGE()));
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionTime, AnUpdateWithoutTimeIsTheResult)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(1));
  Prepare(filter, 5);
  filter->SetSmoothingSteps(2);
  filter->Update();
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 7.0);
  EXPECT_EQ(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 7 * 0.1);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionTime, TimesSnapAndClamp)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(1));
  Prepare(filter, 10);
  filter->SetOutputInterval(5);
  EXPECT_EQ(IterationAt(filter, -3.0), 0.0);
  EXPECT_EQ(IterationAt(filter, 0.0), 0.0);
  EXPECT_EQ(IterationAt(filter, 0.2), 0.0);
  EXPECT_EQ(IterationAt(filter, 0.3), 5.0);
  EXPECT_EQ(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 5 * 0.1);
  EXPECT_EQ(IterationAt(filter, 0.8), 10.0);
  EXPECT_EQ(IterationAt(filter, 1e9), 10.0);
  EXPECT_EQ(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 10 * 0.1);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionTime, NoStepsLeaveTheStart)
{
  vtkNew<vtkSurfaceEvolution> filter;
  const auto start = Sample::Icosphere(1);
  filter->SetInputData(start);
  Prepare(filter, 0);
  filter->Update();
  EXPECT_EQ(TimesOf(filter), std::vector<double>({ 0.0 }));
  EXPECT_TRUE(SameSurface(start, filter->GetOutput(), 0.0));
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionTime, ATemporalInputGivesItsLastStepAndIsAskedOnce)
{
  vtkNew<TemporalSphere> source;
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputConnection(source->GetOutputPort());
  Prepare(filter, 4);
  for (const int k : { 0, 3, 1, 4 })
  {
    filter->UpdateTimeStep(k * 0.1);
  }
  EXPECT_EQ(source->Asked, std::vector<double>({ 2.0 }));
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
  filter->UpdateTimeStep(0.0);
  EXPECT_NEAR(DistanceFromOrigin(filter->GetOutput()).Largest, 3.0, 1e-6);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionTime, EvolutionsInARowTakeEachOthersResult)
{
  vtkNew<vtkSurfaceEvolution> first;
  first->SetInputData(Sample::Icosphere(1));
  Prepare(first, 3);
  vtkNew<vtkSurfaceEvolution> second;
  second->SetInputConnection(first->GetOutputPort());
  Prepare(second, 2);
  EXPECT_EQ(TimesOf(second), std::vector<double>({ 0.0, 0.1, 0.2 }));
  second->UpdateTimeStep(0.0);
  first->Update();
  EXPECT_TRUE(SameSurface(first->GetOutput(), second->GetOutput(), 0.0));
}

} // namespace
