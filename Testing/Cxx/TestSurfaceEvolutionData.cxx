// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution: its point arrays, field arrays and history.

#include "DataChecks.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace
{

using Names = std::vector<std::string>;

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionData, PointArraysAreNamedAsPromised)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpAttraction(filter, Sample::Icosphere(2, 1.5));
  filter->SetVolumeRedistribution(1.0);
  filter->Update();
  const Names expected = { "SignedDistance", "DistanceGradient", "Normals", "MeanCurvature",
    "CoVolume", "NormalVelocity", "TangentialVelocity", "RedistributionPotential" };
  EXPECT_EQ(ArrayNames(filter->GetOutput()->GetPointData()), Sorted(expected));
  EXPECT_TRUE(IsFinite(filter->GetOutput()));
  filter->SetInputData(1, nullptr);
  filter->Update();
  const Names without(expected.begin() + 2, expected.end());
  EXPECT_EQ(ArrayNames(filter->GetOutput()->GetPointData()), Sorted(without));
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionData, PointArraysOfASphere)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpAttraction(filter, Sample::Icosphere(3, 1.5));
  filter->SetAngleRedistribution(1.0);
  filter->UpdateTimeStep(0.0);
  vtkPolyData* output = filter->GetOutput();
  double area = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto vector = [&](const char* name)
    { return output->GetPointData()->GetArray(name)->GetTuple3(i); };
    const auto scalar = [&](const char* name)
    { return output->GetPointData()->GetArray(name)->GetTuple1(i); };
    double normal[3];
    double outwards[3];
    std::copy_n(vector("Normals"), 3, normal);
    output->GetPoint(i, outwards);
    vtkMath::Normalize(outwards);
    ASSERT_NEAR(vtkMath::Norm(normal), 1.0, 1e-9);
    ASSERT_GT(vtkMath::Dot(normal, outwards), 0.999);
    ASSERT_GT(vtkMath::Dot(vector("DistanceGradient"), outwards), 0.99);
    ASSERT_NEAR(vtkMath::Dot(vector("TangentialVelocity"), normal), 0.0, 1e-9);
    // The co-volumes of the twelve points with five neighbours are small: 14 % off there.
    ASSERT_NEAR(scalar("MeanCurvature"), 2.0 / 1.5, i < 12 ? 0.2 : 0.05);
    ASSERT_NEAR(scalar("SignedDistance"), 0.5, 0.01);
    ASSERT_LT(scalar("NormalVelocity"), -0.45);
    area += scalar("CoVolume");
  }
  EXPECT_NEAR(area, AreaOf(output), 1e-9);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionData, FieldArraysMeasureTheSurface)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpAttraction(filter, Sample::Icosphere(2, 1.5));
  filter->UpdateTimeStep(0.5);
  vtkPolyData* output = filter->GetOutput();
  const Names expected = { "Iteration", "Time", "TimeStep", "Area", "Volume", "MeanDistance",
    "MaxDistance", "MinAngle" };
  EXPECT_EQ(ArrayNames(output->GetFieldData()), Sorted(expected));
  EXPECT_EQ(FieldValue(output, "Iteration"), 5.0);
  EXPECT_DOUBLE_EQ(FieldValue(output, "Time"), 0.5);
  EXPECT_NEAR(FieldValue(output, "Area"), AreaOf(output), 1e-9);
  EXPECT_NEAR(FieldValue(output, "Volume"), VolumeOf(output), 1e-9);
  EXPECT_NEAR(FieldValue(output, "MinAngle"), SmallestAngleOf(output), 1e-6);
  EXPECT_LE(FieldValue(output, "MeanDistance"), FieldValue(output, "MaxDistance"));
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionData, HistoryHasARowForEveryStep)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpAttraction(filter, Sample::Icosphere(2, 1.5));
  filter->SetOutputInterval(10);
  filter->SetSmoothingSteps(3);
  filter->Update();
  vtkTable* history = HistoryOf(filter);
  const Names expected = { "Time", "Iteration", "Area", "Volume", "MeanDistance", "MaxDistance",
    "MinAngle", "SolverIterations", "Seconds" };
  EXPECT_EQ(ColumnNames(history), Sorted(expected));
  ASSERT_EQ(history->GetNumberOfRows(), 44);
  for (vtkIdType row = 0; row < history->GetNumberOfRows(); ++row)
  {
    ASSERT_EQ(ValueAt(history, row, "Iteration"), static_cast<double>(row));
    ASSERT_DOUBLE_EQ(ValueAt(history, row, "Time"), 0.1 * static_cast<double>(row));
  }
  EXPECT_TRUE(IsFinite(history));
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionData, HistoryAgreesWithTheStates)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpAttraction(filter, Sample::Icosphere(2, 1.5));
  for (const int step : { 0, 7, 40 })
  {
    filter->UpdateTimeStep(step * 0.1);
    for (const char* name : { "Area", "Volume", "MeanDistance", "MaxDistance", "MinAngle" })
    {
      EXPECT_EQ(FieldValue(filter->GetOutput(), name), ValueAt(HistoryOf(filter), step, name));
    }
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionData, HistoryAloneCanBeAsked)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpAttraction(filter, Sample::Icosphere(1, 1.5));
  filter->Update(1);
  EXPECT_EQ(HistoryOf(filter)->GetNumberOfRows(), 41);
  filter->Update(0);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 40.0);
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
}

} // namespace
