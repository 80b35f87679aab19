// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Progress moves forwards, and an abort ends at the next look, with nothing half-done kept.

#include "DataChecks.h"
#include "EventLog.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkDistanceHierarchy.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using Filter = vtkSmartPointer<vtkAlgorithm>;

//------------------------------------------------------------------------------
Filter MakeDistance(int method)
{
  auto filter = vtkSmartPointer<vtkMeshSDF>::New();
  filter->SetInputData(Sample::Read("bunny.ply"));
  filter->SetSampleDimensions(48, 48, 48);
  filter->SetMethod(method);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeEvolution()
{
  auto filter = vtkSmartPointer<vtkSurfaceEvolution>::New();
  filter->SetInputData(Sample::Icosphere(2));
  filter->SetTimeStep(0.01);
  filter->SetNumberOfSteps(50);
  filter->SetVolumeRedistribution(1.0);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeRedistribution()
{
  auto filter = vtkSmartPointer<vtkTangentialRedistribution>::New();
  filter->SetInputData(Sample::Icosphere(3));
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeWrap()
{
  auto filter = vtkSmartPointer<vtkShrinkWrap>::New();
  filter->SetInputData(Sample::Icosphere(2));
  filter->SetSampleDimensions(24, 24, 24);
  filter->SetTargetEdgeLength(0.2);
  filter->SetNumberOfSteps(20);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeHierarchy()
{
  auto filter = vtkSmartPointer<vtkDistanceHierarchy>::New();
  filter->SetInputData(Sample::Read("bunny.ply"));
  filter->SetStructureToOctree();
  return filter;
}

//------------------------------------------------------------------------------
using Case = std::pair<const char*, Filter (*)()>;

class LongRun : public testing::TestWithParam<Case>
{
};

TEST_P(LongRun, ProgressMovesForwardsFromZeroToOne)
{
  const Filter filter = GetParam().second();
  EventLog log(filter);
  filter->Update();
  ASSERT_GT(log.Progress.size(), 5u);
  // To rounding: phases of phases are sums of products.
  EXPECT_TRUE(std::is_sorted(
    log.Progress.begin(), log.Progress.end(), [](double a, double b) { return a < b - 1e-12; }));
  EXPECT_GE(log.Progress.front(), 0.0);
  EXPECT_EQ(log.Progress.back(), 1.0);
  // More than the ends: something is told on the way.
  EXPECT_GT(std::count_if(log.Progress.begin(), log.Progress.end(),
              [](double fraction) { return fraction > 0.05 && fraction < 0.95; }),
    2);
}

TEST_P(LongRun, AnAbortEndsAtOnceWithEmptyOutput)
{
  for (const double when : { 0.01, 0.5 })
  {
    const Filter filter = GetParam().second();
    EventLog log(filter);
    std::size_t seen = 0;
    log.OnProgress = [&](double fraction)
    {
      if (fraction >= when && seen == 0)
      {
        seen = log.Progress.size();
        filter->SetAbortExecute(1);
      }
    };
    filter->Update();
    ASSERT_GT(seen, 0u);
    EXPECT_LE(log.Progress.size(), seen + 1) << "went on after the abort";
    EXPECT_TRUE(log.Errors.empty());
    EXPECT_TRUE(log.Warnings.empty());
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      EXPECT_TRUE(IsInitialized(filter->GetOutputDataObject(port)));
    }
    EXPECT_EQ(filter->GetAbortExecute(), 1);
  }
}

TEST_P(LongRun, AfterAnAbortTheFullResultIsThere)
{
  const Filter undisturbed = GetParam().second();
  undisturbed->Update();
  const Filter filter = GetParam().second();
  {
    EventLog log(filter);
    log.OnProgress = [&](double fraction)
    {
      if (fraction > 0.4)
      {
        filter->SetAbortExecute(1);
      }
    };
    filter->Update();
  }
  filter->SetAbortExecute(0);
  filter->Update();
  if (auto* image = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0)))
  {
    EXPECT_TRUE(SameImage(image, vtkImageData::SafeDownCast(undisturbed->GetOutputDataObject(0))));
    return;
  }
  auto* surface = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  auto* expected = vtkPolyData::SafeDownCast(undisturbed->GetOutputDataObject(0));
  ASSERT_GT(surface->GetNumberOfPoints(), 0);
  EXPECT_TRUE(SameSurface(surface, expected, 0.0));
  EXPECT_TRUE(SamePointArrays(surface, expected, 0.0));
}

INSTANTIATE_TEST_SUITE_P(Filters, LongRun,
  testing::Values(Case{ "ClosestPoint", []() { return MakeDistance(vtkMeshSDF::CLOSEST_POINT); } },
    Case{ "FastSweeping", []() { return MakeDistance(vtkMeshSDF::FAST_SWEEPING); } },
    Case{ "BruteForce", []() { return MakeDistance(vtkMeshSDF::BRUTE_FORCE); } },
    Case{ "Evolution", MakeEvolution }, Case{ "Redistribution", MakeRedistribution },
    Case{ "Wrap", MakeWrap }, Case{ "Hierarchy", MakeHierarchy }),
  [](const testing::TestParamInfo<Case>& info) { return info.param.first; });

//------------------------------------------------------------------------------
TEST(Abort, OfASolveKeepsNoStates)
{
  const Filter made = MakeEvolution();
  auto* filter = vtkSurfaceEvolution::SafeDownCast(made);
  {
    EventLog log(filter);
    log.OnProgress = [&](double fraction)
    {
      if (fraction > 0.4)
      {
        filter->SetAbortExecute(1);
      }
    };
    filter->UpdateTimeStep(0.0);
  }
  // Still aborted: nothing is handed out for the times before the abort either.
  filter->UpdateTimeStep(0.1);
  EXPECT_TRUE(IsInitialized(filter->GetOutput()));
  filter->SetAbortExecute(0);
  filter->UpdateTimeStep(0.0);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 0.0);
  filter->UpdateTimeStep(0.5);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 50.0);
}

//------------------------------------------------------------------------------
TEST(Abort, AfterASolveKeepsIt)
{
  const Filter made = MakeEvolution();
  auto* filter = vtkSurfaceEvolution::SafeDownCast(made);
  filter->Update();
  filter->SetAbortExecute(1);
  filter->UpdateTimeStep(0.1);
  filter->SetAbortExecute(0);
  filter->UpdateTimeStep(0.2);
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 20.0);
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
}

} // namespace
