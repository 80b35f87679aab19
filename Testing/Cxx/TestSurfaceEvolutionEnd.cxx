// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution: runs that end before their last step.

#include "DataChecks.h"
#include "EventLog.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

using Names = std::vector<std::string>;

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionEnd, ASolveThatCannotGoOnKeepsWhatWasReached)
{
  // The field draws the surface to a sphere that the image has only corners of; the guard lets none
  // leave the image.
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  SetUpAttraction(filter, Sample::Icosphere(2, 0.5));
  filter->SetInputData(1, Sample::SphereImage(17, 2.0, 3.0));
  filter->SetSurfaceGuard(1.0);
  filter->SetAdvectionSpeed(2.0);
  filter->SetTimeStep(0.02);
  filter->Update();
  ASSERT_EQ(log.Errors.size(), 1u);
  EXPECT_TRUE(IsOneSentence(log.Errors.front()));
  vtkPolyData* output = filter->GetOutput();
  const double stopped = FieldValue(output, "Stopped");
  EXPECT_GT(stopped, 5.0);
  EXPECT_LT(stopped, 39.0);
  EXPECT_EQ(FieldValue(output, "Iteration"), stopped);
  EXPECT_EQ(output->GetNumberOfPoints(), 162);
  EXPECT_TRUE(IsFinite(output));
  EXPECT_EQ(HistoryOf(filter)->GetNumberOfRows(), static_cast<vtkIdType>(stopped) + 1);
  // An earlier step is as it was, a later one repeats the last; nobody is told again.
  filter->UpdateTimeStep(0.04);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 2.0);
  filter->UpdateTimeStep(0.8);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), stopped);
  EXPECT_EQ(log.Errors.size(), 1u);
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionEnd, ExtinctionIsAnEndAndNoError)
{
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  SetUpCurvatureFlow(filter, Sample::Icosphere(3), 0.005, 100);
  filter->SetOutputInterval(7);
  EXPECT_EQ(TimesOf(filter).size(), 16u); // as they were asked for
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  vtkPolyData* output = filter->GetOutput();
  EXPECT_FALSE(output->GetFieldData()->HasArray("Stopped"));
  const double end = FieldValue(output, "ExtinctionTime");
  EXPECT_NEAR(end, 0.25, 0.015); // implicit steps are late by three of them
  // The last time is that of the last good surface.
  const double last = FieldValue(output, "Time");
  EXPECT_GT(last, end - 0.005);
  EXPECT_EQ(TimesOf(filter).back(), last);
  EXPECT_GT(FieldValue(output, "Area"), 0.0);
  EXPECT_GT(FieldValue(output, "MinAngle"), 40.0);
  EXPECT_EQ(FieldValue(output, "Iteration"), HistoryOf(filter)->GetNumberOfRows() - 1.0);
  filter->UpdateTimeStep(0.5);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Time"), last);
  filter->UpdateTimeStep(0.035);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 7.0);
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
  // Another run has other times.
  filter->SetTimeStep(0.001);
  EXPECT_EQ(TimesOf(filter).back(), 100 * 0.001);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionEnd, ConvergenceEndsTheRunButNotTheTimes)
{
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  SetUpAttraction(filter, Sample::Icosphere(2, 1.5));
  filter->SetNumberOfSteps(500);
  filter->SetConvergenceTolerance(1e-3);
  filter->UpdateTimeStep(50.0);
  EXPECT_TRUE(log.Errors.empty());
  const vtkIdType rows = HistoryOf(filter)->GetNumberOfRows();
  EXPECT_LT(rows, 200);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), static_cast<double>(rows) - 1.0);
  EXPECT_LT(FieldValue(filter->GetOutput(), "MaxDistance"), 0.02);
}

//------------------------------------------------------------------------------
/// A triangle of three points.
vtkSmartPointer<vtkPolyData> Triangle(const double corners[3][3])
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(3);
  for (int k = 0; k < 3; ++k)
  {
    polygons->InsertCellPoint(points->InsertNextPoint(corners[k]));
  }
  auto triangle = vtkSmartPointer<vtkPolyData>::New();
  triangle->SetPoints(points);
  triangle->SetPolys(polygons);
  return triangle;
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionEnd, FacesWithoutAreaAreRefusedWithRemeshingToo)
{
  const double twice[3][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 } };
  const double inLine[3][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  for (const auto& corners : { twice, inLine })
  {
    for (int remeshing = 0; remeshing <= 2; ++remeshing)
    {
      vtkNew<vtkSurfaceEvolution> filter;
      EventLog log(filter);
      filter->SetInputData(Triangle(corners));
      filter->SetRemeshing(remeshing);
      filter->SetNumberOfSteps(2);
      filter->Update();
      ASSERT_EQ(log.Errors.size(), 1u);
      EXPECT_TRUE(IsOneSentence(log.Errors.front()));
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    }
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionEnd, ANeedleHasFewPoints)
{
  for (const double width : { 1e-6, 1e-14 })
  {
    const double corners[3][3] = { { 0, 0, 0 }, { width, 0, 0 }, { 0, 0.1, 0 } };
    vtkNew<vtkSurfaceEvolution> filter;
    filter->SetInputData(Triangle(corners));
    filter->SetRemeshingToUniform();
    filter->SetNumberOfSteps(1);
    filter->Update();
    EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 3);
    EXPECT_LT(filter->GetOutput()->GetNumberOfPoints(), 2000);
  }
}

} // namespace
