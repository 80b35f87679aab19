// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Inputs with time steps: filters without times of their own follow them, others take one.

#include "DataChecks.h"
#include "FilterRuns.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"
#include "TemporalSphere.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;
const std::vector<double> SourceTimes = { 0.0, 1.0, 2.0 };

//------------------------------------------------------------------------------
double TimeOf(vtkDataObject* data)
{
  return data->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
}

//------------------------------------------------------------------------------
void SetUpSmall(vtkShrinkWrap* filter, vtkAlgorithm* source)
{
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetSampleDimensions(24, 24, 24);
  filter->SetTargetNumberOfPoints(300);
}

//------------------------------------------------------------------------------
TEST(InputTimes, AWrapIsOfTheTimeThatIsAskedFor)
{
  vtkNew<TemporalSphere> source;
  vtkNew<vtkShrinkWrap> filter;
  SetUpSmall(filter, source);
  EXPECT_EQ(TimesOf(filter, 0), SourceTimes);
  EXPECT_EQ(TimesOf(filter, 1), SourceTimes);
  for (const double time : { 2.0, 0.0, 1.0 })
  {
    filter->UpdateTimeStep(time);
    EXPECT_NEAR(DistanceFromOrigin(filter->GetOutput()).Largest, 1.0 + time, 0.05 * (1.0 + time));
    EXPECT_EQ(TimeOf(filter->GetOutput()), time);
    EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("InputTime"));
  }
  EXPECT_EQ(source->Asked, std::vector<double>({ 2.0, 0.0, 1.0 }));
  EXPECT_EQ(filter->GetNumberOfSolves(), 3);
  filter->UpdateTimeStep(1.0);
  EXPECT_EQ(filter->GetNumberOfSolves(), 3);
}

//------------------------------------------------------------------------------
TEST(InputTimes, AWrapsOwnTimesComeAndGo)
{
  vtkNew<TemporalSphere> source;
  vtkNew<vtkShrinkWrap> filter;
  SetUpSmall(filter, source);
  filter->OutputStepsOn();
  filter->SetInputTimeToFirstStep();
  const std::vector<double> own = TimesOf(filter, 0);
  EXPECT_EQ(own.size(), 5u);
  EXPECT_TRUE(TimesOf(filter, 1).empty());
  filter->UpdateTimeStep(own[2]);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "InputTime"), 0.0);
  filter->UpdateTimeStep(own[4]);
  EXPECT_NEAR(DistanceFromOrigin(filter->GetOutput()).Largest, 1.0, 0.05);
  EXPECT_EQ(source->Asked, std::vector<double>({ 0.0 }));
  filter->OutputStepsOff();
  EXPECT_EQ(TimesOf(filter, 0), SourceTimes);
  EXPECT_EQ(TimesOf(filter, 1), SourceTimes);
  filter->SetInputConnection(nullptr);
  filter->SetInputData(Sample::Icosphere(1));
  EXPECT_TRUE(TimesOf(filter, 0).empty());
}

//------------------------------------------------------------------------------
TEST(InputTimes, AnEvolutionTakesTheOneThatIsChosen)
{
  vtkNew<TemporalSphere> source;
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetNumberOfSteps(2);
  const auto expectTime = [&](double time)
  {
    filter->UpdateTimeStep(0.0);
    EXPECT_NEAR(DistanceFromOrigin(filter->GetOutput()).Largest, 1.0 + time, 1e-6);
    EXPECT_EQ(FieldValue(filter->GetOutput(), "InputTime"), time);
    EXPECT_EQ(TimeOf(filter->GetOutput()), 0.0);
  };
  expectTime(2.0);
  filter->SetInputTimeToFirstStep();
  expectTime(0.0);
  filter->SetInputTimeToStepIndex();
  filter->SetInputTimeIndex(1);
  expectTime(1.0);
  filter->SetInputTimeIndex(3);
  ExpectRefusalOf(filter, "InputTimeIndex is 3");
  filter->SetInputTimeToLastStep();
  expectTime(2.0);
}

//------------------------------------------------------------------------------
TEST(InputTimes, FieldsWithTimesLikewise)
{
  vtkNew<TemporalSphere> source;
  vtkNew<vtkMeshSDF> distance;
  distance->SetInputConnection(source->GetOutputPort());
  distance->SetSampleDimensions(24, 24, 24);
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(0, Sample::Icosphere(2, 1.2));
  filter->SetDistanceFieldConnection(distance->GetOutputPort());
  filter->SetRemeshingToOff();
  filter->SetInputTimeToFirstStep();
  filter->Update();
  EXPECT_NEAR(DistanceFromOrigin(filter->GetOutput()).Largest, 1.0, 0.05);
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("InputTime")); // the surface has none
  filter->SetInputTimeToStepIndex();
  filter->SetInputTimeIndex(1);
  filter->Update();
  EXPECT_NEAR(DistanceFromOrigin(filter->GetOutput()).Largest, 2.0, 0.1);
  filter->SetInputTimeIndex(5);
  ExpectRefusalOf(filter, "3 time steps");
}

//------------------------------------------------------------------------------
TEST(InputTimes, WithoutTimesThereIsNothingToChoose)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(1));
  filter->SetNumberOfSteps(1);
  filter->SetInputTimeToStepIndex();
  filter->SetInputTimeIndex(7);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 42);
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("InputTime"));
}

//------------------------------------------------------------------------------
TEST(InputTimes, DistancesAndRedistributionsFollow)
{
  vtkNew<TemporalSphere> source;
  vtkNew<vtkTangentialRedistribution> even;
  even->SetInputConnection(source->GetOutputPort());
  even->SetNumberOfSteps(1);
  vtkNew<vtkMeshSDF> distance;
  distance->SetInputConnection(even->GetOutputPort());
  distance->SetSampleDimensions(9, 9, 9);
  distance->SetPadding(0.0);
  EXPECT_EQ(TimesOf(distance), SourceTimes);
  for (const double time : { 1.0, 0.0, 2.0 })
  {
    distance->UpdateTimeStep(time);
    double bounds[6];
    distance->GetOutput()->GetBounds(bounds);
    EXPECT_NEAR(bounds[1], 1.0 + time, 0.1 * (1.0 + time));
  }
}

} // namespace
