// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution: does an element ever turn over on the way to a model with sharp edges or a
// concavity?

#include "DataChecks.h"
#include "ElementFlips.h"
#include "EventLog.h"
#include "SampleSurfaces.h"

#include "vtkIcosphereSource.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

struct Target
{
  const char* File;
  int Level;
  double MaxDistance; ///< at the end, in the model's units
};

//------------------------------------------------------------------------------
class PlainEvolution : public testing::TestWithParam<Target>
{
protected:
  PlainEvolution()
  {
    const Sample::Surface model = Sample::Read(GetParam().File);
    this->Distance->SetInputData(model);
    this->Start->SetLevel(GetParam().Level);
    this->Start->SetCenter(model->GetCenter());
    this->Start->SetRadius(0.55 * model->GetLength()); // around the box
    this->Evolution->SetInputConnection(0, this->Start->GetOutputPort());
    this->Evolution->SetInputConnection(1, this->Distance->GetOutputPort());
    this->Evolution->SetTimeStep(0.03);
    this->Evolution->SetConvergenceTolerance(0.0);
    this->Evolution->SetRemeshingToOff();
  }

  vtkNew<vtkMeshSDF> Distance;
  vtkNew<vtkIcosphereSource> Start;
  vtkNew<vtkSurfaceEvolution> Evolution;
};

//------------------------------------------------------------------------------
TEST_P(PlainEvolution, TurnsNoElementOver)
{
  EventLog log(this->Evolution);
  const int steps = this->Evolution->GetNumberOfSteps();
  const double timeStep = this->Evolution->GetTimeStep();
  vtkNew<vtkPolyData> before;
  for (int k = 0; k <= steps; ++k)
  {
    this->Evolution->UpdateTimeStep(k * timeStep);
    vtkPolyData* now = this->Evolution->GetOutput();
    ASSERT_EQ(FieldValue(now, "Iteration"), k);
    EXPECT_EQ(CountFolded(now), 0) << "step " << k;
    EXPECT_EQ(k == 0 ? 0 : CountTurned(before, now), 0) << "step " << k;
    before->DeepCopy(now);
  }
  EXPECT_EQ(this->Evolution->GetNumberOfSolves(), 1);
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_LT(FieldValue(before, "MaxDistance"), GetParam().MaxDistance);
}

// After T = 4.5 a surface is still e^-4.5 = 1.1 % of its first distance away; the arc's inside is
// farther by the curvature of the surface that goes there.
INSTANTIATE_TEST_SUITE_P(Models, PlainEvolution,
  testing::Values(Target{ "cube.obj", 3, 0.005 }, Target{ "cube.obj", 4, 0.005 },
    Target{ "arc.vtk", 3, 0.045 }, Target{ "arc.vtk", 4, 0.04 }));

//------------------------------------------------------------------------------
TEST(ElementFlips, AreSeenWhenTheyHappen)
{
  // A point of the sheet pushed over its neighbour turns one triangle or more.
  const Sample::Surface sheet = Sample::Sheet(4);
  vtkNew<vtkPolyData> folded;
  folded->DeepCopy(sheet);
  folded->GetPoints()->SetPoint(12, 0.6, 0.1, 0.0);
  EXPECT_EQ(CountFolded(sheet), 0);
  EXPECT_EQ(CountTurned(sheet, sheet), 0);
  EXPECT_GT(CountTurned(sheet, folded), 0);
  EXPECT_EQ(CountFolded(folded), CountTurned(sheet, folded));
}

} // namespace
