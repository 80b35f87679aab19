// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution as it is, with a surface and nothing else: it must end well on anything
// closed.

#include "DataChecks.h"
#include "ElementFlips.h"
#include "EventLog.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

//------------------------------------------------------------------------------
Sample::Surface Scaled(vtkPolyData* surface, double factor)
{
  auto scaled = Sample::Surface::New();
  scaled->DeepCopy(surface);
  for (vtkIdType i = 0; i < scaled->GetNumberOfPoints(); ++i)
  {
    double point[3];
    scaled->GetPoint(i, point);
    scaled->GetPoints()->SetPoint(i, factor * point[0], factor * point[1], factor * point[2]);
  }
  return scaled;
}

//------------------------------------------------------------------------------
Sample::Surface Model(const std::string& name)
{
  return name == "icosphere" ? Sample::Icosphere(3)
    : name == "cubesphere"   ? Sample::CubeSphere(10)
                             : Sample::Read(name);
}

class DefaultEvolution : public testing::TestWithParam<const char*>
{
};

} // namespace

//------------------------------------------------------------------------------
TEST_P(DefaultEvolution, LooksWellAtAnyTime)
{
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  filter->SetInputData(Model(GetParam()));
  vtkNew<vtkPolyData> before;
  double first = 0.0;
  for (int k = 0; k <= filter->GetNumberOfSteps(); ++k)
  {
    filter->UpdateTimeStep(k);
    vtkPolyData* now = filter->GetOutput();
    ASSERT_EQ(FieldValue(now, "Iteration"), k);
    const bool hasSameElements = now->GetNumberOfPoints() == before->GetNumberOfPoints() &&
      Sample::PolygonsOf(now) == Sample::PolygonsOf(before);
    EXPECT_EQ(k > 0 && hasSameElements ? CountTurned(before, now) : 0, 0) << "step " << k;
    EXPECT_EQ(k > 0 ? CountFolded(now) : 0, 0) << "step " << k;
    EXPECT_GT(k > 0 ? FieldValue(now, "MinAngle") : 90.0, 19.0) << "step " << k;
    EXPECT_LT(FieldValue(now, "Area"), k > 0 ? FieldValue(before, "Area") : VTK_DOUBLE_MAX)
      << "step " << k;
    first = k == 0 ? FieldValue(now, "Area") : first;
    before->DeepCopy(now);
  }
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
  // A half of the way: it is another shape, and there is something left.
  EXPECT_LT(FieldValue(before, "Area"), 0.6 * first);
  EXPECT_GT(FieldValue(before, "Area"), 0.3 * first);
}

//------------------------------------------------------------------------------
TEST_P(DefaultEvolution, IsTheSameAtAnyScale)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Model(GetParam()));
  filter->Update();
  for (const double factor : { 1.0 / 1024, 1024.0 })
  {
    vtkNew<vtkSurfaceEvolution> other;
    EventLog log(other);
    other->SetInputData(Scaled(Model(GetParam()), factor));
    other->Update();
    EXPECT_TRUE(log.Errors.empty());
    const double step = FieldValue(filter->GetOutput(), "TimeStep");
    EXPECT_NEAR(FieldValue(other->GetOutput(), "TimeStep"), step, 1e-9 * step);
    const double area = FieldValue(filter->GetOutput(), "Area");
    EXPECT_NEAR(FieldValue(other->GetOutput(), "Area") / (factor * factor), area, 1e-6 * area);
  }
}

//------------------------------------------------------------------------------
TEST_P(DefaultEvolution, EndsInAPointWhenItIsLongEnough)
{
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  filter->SetInputData(Model(GetParam()));
  filter->Update();
  filter->SetTimeStep(FieldValue(filter->GetOutput(), "TimeStep"));
  filter->SetNumberOfSteps(2000);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  const double last = FieldValue(filter->GetOutput(), "Iteration");
  EXPECT_LT(last, 1000.0);
  EXPECT_GT(FieldValue(filter->GetOutput(), "ExtinctionTime"), 0.0);
  EXPECT_EQ(TimesOf(filter).size(), static_cast<std::size_t>(last) + 1);
  EXPECT_TRUE(IsFinite(filter->GetOutput()));
  EXPECT_EQ(CountFolded(filter->GetOutput()), 0);
}

INSTANTIATE_TEST_SUITE_P(Models, DefaultEvolution,
  testing::Values("icosphere", "cubesphere", "bunny.ply", "arc.vtk", "bar_heap.ply", "torus.ply",
    "genus_two.obj"));

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionDefaults, TimesAreNumbersOfStepsAndTheTimeIsInTheData)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(2));
  filter->SetNumberOfSteps(4);
  EXPECT_EQ(TimesOf(filter), std::vector<double>({ 0.0, 1.0, 2.0, 3.0, 4.0 }));
  filter->UpdateTimeStep(3.0);
  const double step = FieldValue(filter->GetOutput(), "TimeStep");
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 3.0);
  EXPECT_DOUBLE_EQ(FieldValue(filter->GetOutput(), "Time"), 3.0 * step);
  // The same step, when it is asked for, gives the same surface.
  vtkNew<vtkSurfaceEvolution> other;
  other->SetInputData(Sample::Icosphere(2));
  other->SetNumberOfSteps(4);
  other->SetTimeStep(step);
  other->UpdateTimeStep(3.0 * step);
  EXPECT_TRUE(SameSurface(filter->GetOutput(), other->GetOutput(), 0.0));
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionDefaults, AMinimalSurfaceComesToRest)
{
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  filter->SetInputData(Sample::Read("bowl.ply"));
  filter->SetNumberOfSteps(1000);
  filter->SetTimeStep(0.02);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_LT(HistoryOf(filter)->GetNumberOfRows(), 900);
}
