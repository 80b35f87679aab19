// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkShrinkWrap: its steps, its history, and what it refuses.

#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
TEST(ShrinkWrapSteps, TheResultAlonePublishesNoTime)
{
  vtkNew<vtkShrinkWrap> filter;
  SetUpCoarsely(filter, Sample::Icosphere(2));
  filter->UpdateInformation();
  EXPECT_FALSE(filter->GetOutputInformation(0)->Has(Pipeline::TIME_STEPS()));
  EXPECT_FALSE(filter->GetOutputInformation(1)->Has(Pipeline::TIME_STEPS()));
  filter->UpdateTimeStep(0.0);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 30.0);
  EXPECT_FALSE(filter->GetOutput()->GetInformation()->Has(vtkDataObject::DATA_TIME_STEP()));
}

//------------------------------------------------------------------------------
TEST(ShrinkWrapSteps, OutputStepsPublishTheSeriesOfOneSolve)
{
  vtkNew<vtkShrinkWrap> filter;
  SetUpCoarsely(filter, Sample::Icosphere(2));
  filter->OutputStepsOn();
  filter->UpdateInformation();
  vtkInformation* info = filter->GetOutputInformation(0);
  ASSERT_EQ(info->Length(Pipeline::TIME_STEPS()), 31);
  EXPECT_FALSE(filter->GetOutputInformation(1)->Has(Pipeline::TIME_STEPS()));
  const std::vector<double> times(
    info->Get(Pipeline::TIME_STEPS()), info->Get(Pipeline::TIME_STEPS()) + 31);
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
  filter->UpdateTimeStep(times[0]);
  const double start = DistanceFromOrigin(filter->GetOutput()).Largest;
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 0.0);
  filter->UpdateTimeStep(times[30]);
  EXPECT_LT(DistanceFromOrigin(filter->GetOutput()).Largest, start);
  ExpectClosed(filter->GetOutput(), 0);
  filter->UpdateTimeStep(times[12]);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 12.0);
  EXPECT_EQ(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), times[12]);
  filter->OutputStepsOff();
  filter->Update();
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 30.0);
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
}

//------------------------------------------------------------------------------
TEST(ShrinkWrapSteps, HistoryTellsOfTheWay)
{
  vtkNew<vtkShrinkWrap> filter;
  SetUpCoarsely(filter, Sample::Icosphere(2));
  filter->Update();
  auto* history = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(history->GetNumberOfRows(), 31);
  // What the grid makes of the distance of a surface that lies on the target: some of a cell.
  EXPECT_LT(history->GetValueByName(30, "MeanDistance").ToDouble(),
    0.5 * history->GetValueByName(0, "MeanDistance").ToDouble());
}

} // namespace
