// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution with Remeshing: time steps of different connectivity.

#include "DataChecks.h"
#include "EventLog.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{

constexpr int Modes[] = { vtkSurfaceEvolution::UNIFORM, vtkSurfaceEvolution::CURVATURE_ADAPTIVE };

//------------------------------------------------------------------------------
/// From a ball of four times as long elements as wanted onto the unit sphere.
void SetUpRemeshing(vtkSurfaceEvolution* filter, int mode)
{
  SetUpAttraction(filter, Sample::Icosphere(2, 1.5));
  filter->SetNumberOfSteps(20);
  filter->SetRemeshing(mode);
  filter->SetTargetEdgeLength(0.12);
  filter->SetRemeshingInterval(4);
}

//------------------------------------------------------------------------------
void ExpectWholeState(vtkSurfaceEvolution* filter, int step)
{
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(CountBadEdges(output), 0);
  EXPECT_EQ(EulerCharacteristic(output), 2);
  EXPECT_TRUE(IsFinite(output));
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 8);
  for (int i = 0; i < output->GetPointData()->GetNumberOfArrays(); ++i)
  {
    EXPECT_EQ(
      output->GetPointData()->GetArray(i)->GetNumberOfTuples(), output->GetNumberOfPoints());
  }
  EXPECT_EQ(FieldValue(output, "Iteration"), static_cast<double>(step));
  EXPECT_NEAR(FieldValue(output, "Area"), AreaOf(output), 1e-4 * AreaOf(output));
  EXPECT_NEAR(FieldValue(output, "Volume"), VolumeOf(output), 1e-4 * VolumeOf(output));
  EXPECT_NEAR(FieldValue(output, "MinAngle"), SmallestAngleOf(output), 0.01);
  vtkTable* history = HistoryOf(filter);
  EXPECT_EQ(ValueAt(history, step, "Area"), FieldValue(output, "Area"));
  EXPECT_EQ(ValueAt(history, step, "MaxDistance"), FieldValue(output, "MaxDistance"));
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionRemeshing, EveryTimeStepIsWholeInAnyOrder)
{
  for (const int mode : Modes)
  {
    vtkNew<vtkSurfaceEvolution> filter;
    EventLog log(filter);
    SetUpRemeshing(filter, mode);
    std::set<vtkIdType> counts;
    for (const int step : { 0, 3, 4, 8, 12, 20, 19, 4, 0, 16 })
    {
      SCOPED_TRACE("step " + std::to_string(step));
      filter->UpdateTimeStep(step * filter->GetTimeStep());
      ExpectWholeState(filter, step);
      counts.insert(filter->GetOutput()->GetNumberOfPoints());
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints() == 162, step < 4);
    }
    EXPECT_GE(counts.size(), 3u);
    EXPECT_TRUE(log.Errors.empty());
    EXPECT_EQ(filter->GetNumberOfSolves(), 1);
    EXPECT_EQ(HistoryOf(filter)->GetNumberOfRows(), 21);
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionRemeshing, TheResultHasGoodElementsOfTheLength)
{
  for (const int mode : Modes)
  {
    vtkNew<vtkSurfaceEvolution> filter;
    SetUpRemeshing(filter, mode);
    filter->Update();
    vtkPolyData* output = filter->GetOutput();
    EXPECT_GT(SmallestAngleOf(output), 38.0);
    // Equilateral triangles of the edge length have the area sqrt(3)/4 of its square.
    const double edge =
      std::sqrt(4.0 / std::sqrt(3.0) * AreaOf(output) / output->GetNumberOfPolys());
    EXPECT_NEAR(edge, 0.12, 0.012);
    EXPECT_LT(FieldValue(output, "MaxDistance"), 0.08);
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionRemeshing, DroppedStatesComeBackWithTheirElements)
{
  vtkNew<vtkSurfaceEvolution> whole;
  vtkNew<vtkSurfaceEvolution> tight;
  for (vtkSurfaceEvolution* filter : { whole.Get(), tight.Get() })
  {
    SetUpAttraction(filter, Sample::Icosphere(4, 1.5));
    filter->SetNumberOfSteps(6);
    filter->SetRemeshing(vtkSurfaceEvolution::UNIFORM);
    filter->SetTargetEdgeLength(0.07);
  }
  tight->SetCacheLimit(1);
  for (const int step : { 6, 5, 1, 3 })
  {
    whole->UpdateTimeStep(step * whole->GetTimeStep());
    tight->UpdateTimeStep(step * tight->GetTimeStep());
    EXPECT_TRUE(SameSurface(whole->GetOutput(), tight->GetOutput(), 1e-6)) << step;
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionRemeshing, OffIsUntouchedByItsParameters)
{
  vtkNew<vtkSurfaceEvolution> plain;
  vtkNew<vtkSurfaceEvolution> other;
  for (vtkSurfaceEvolution* filter : { plain.Get(), other.Get() })
  {
    SetUpAttraction(filter, Sample::CubeSphere(6, 1.5));
    filter->SetNumberOfSteps(10);
  }
  other->SetTargetEdgeLength(0.1);
  other->SetRemeshingInterval(3);
  plain->Update();
  other->Update();
  EXPECT_TRUE(SameSurface(plain->GetOutput(), other->GetOutput(), 0.0));
  EXPECT_EQ(plain->GetOutput()->GetNumberOfPolys(), 6 * 36);
  EXPECT_TRUE(SameBits(plain->GetOutput()->GetPointData()->GetArray("Normals"),
    other->GetOutput()->GetPointData()->GetArray("Normals")));
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionRemeshing, PolygonsBecomeTriangles)
{
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  SetUpAttraction(filter, Sample::CubeSphere(6, 1.5));
  filter->SetNumberOfSteps(5);
  filter->SetRemeshing(vtkSurfaceEvolution::UNIFORM);
  filter->UpdateTimeStep(0.0);
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 2 * 6 * 36);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 6 * 36 + 2);
  filter->UpdateTimeStep(5 * filter->GetTimeStep());
  EXPECT_EQ(CountBadEdges(filter->GetOutput()), 0);
  EXPECT_GT(SmallestAngleOf(filter->GetOutput()), 38.0);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionRemeshing, ParametersSolveAgain)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpRemeshing(filter, vtkSurfaceEvolution::UNIFORM);
  filter->Update();
  filter->SetTargetEdgeLength(0.15);
  filter->Update();
  filter->SetRemeshingInterval(2);
  filter->Update();
  filter->SetRemeshingToCurvatureAdaptive();
  filter->Update();
  filter->SetRemeshingToOff();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 5);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 162);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionRemeshing, AnOpenSheetKeepsItsOutline)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpCurvatureFlow(filter, Sample::Sheet(10), 0.01, 5);
  filter->SetRemeshing(vtkSurfaceEvolution::CURVATURE_ADAPTIVE);
  filter->SetTargetEdgeLength(0.1);
  filter->Update();
  EXPECT_NEAR(AreaOf(filter->GetOutput()), 4.0, 1e-6);
  EXPECT_EQ(EulerCharacteristic(filter->GetOutput()), 1);
  EXPECT_GT(SmallestAngleOf(filter->GetOutput()), 30.0);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 350);
}

} // namespace
