// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkMeshSDF: update after update, with parameters and inputs that change in between.

#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMeshSDF.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace
{

using Filter = vtkSmartPointer<vtkMeshSDF>;

//------------------------------------------------------------------------------
Filter MakeFilter(int method)
{
  auto filter = Filter::New();
  filter->SetInputData(Sample::Icosphere(2));
  filter->SetSampleDimensions(16, 16, 16);
  filter->SetMethod(method);
  return filter;
}

//------------------------------------------------------------------------------
class MeshSDFUpdates : public testing::TestWithParam<int>
{
};

TEST_P(MeshSDFUpdates, ASecondUpdateDoesNothing)
{
  const Filter filter = MakeFilter(GetParam());
  EventLog log(filter);
  filter->Update();
  ASSERT_FALSE(log.Progress.empty());
  log.Clear();
  filter->Update();
  EXPECT_TRUE(log.Progress.empty());
}

TEST_P(MeshSDFUpdates, AChangedParameterGivesWhatAFreshFilterGives)
{
  const std::function<void(vtkMeshSDF*)> changes[] = {
    [](vtkMeshSDF* filter) { filter->SetSignToUnsigned(); },
    [](vtkMeshSDF* filter) { filter->SetSampleDimensions(9, 12, 10); },
    [](vtkMeshSDF* filter) { filter->SetPadding(0.3); },
    [](vtkMeshSDF* filter) { filter->SetBandWidth(2.0); },
    [](vtkMeshSDF* filter) { filter->SetSmoothingSigma(1.0); },
    [](vtkMeshSDF* filter) { filter->SetModelBounds(-1.0, 2.0, -1.0, 2.0, -1.0, 2.0); },
    [](vtkMeshSDF* filter) { filter->SetInputData(Sample::Icosphere(1, 3.0)); },
  };
  for (const auto& change : changes)
  {
    const Filter used = MakeFilter(GetParam());
    used->Update();
    change(used);
    used->Update();
    const Filter fresh = MakeFilter(GetParam());
    const Filter before = MakeFilter(GetParam());
    change(fresh);
    fresh->Update();
    before->Update();
    EXPECT_TRUE(SameImage(fresh->GetOutput(), used->GetOutput()));
    EXPECT_FALSE(SameImage(before->GetOutput(), used->GetOutput()));
  }
}

TEST_P(MeshSDFUpdates, AnArrayNoLongerAskedForIsGone)
{
  const Filter filter = MakeFilter(GetParam());
  filter->ComputeGradientOn();
  filter->Update();
  ASSERT_NE(filter->GetOutput()->GetPointData()->GetArray("Gradient"), nullptr);
  filter->ComputeGradientOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Gradient"), nullptr);
}

TEST_P(MeshSDFUpdates, AfterAnErrorTheNextInputIsFine)
{
  const Filter filter = MakeFilter(GetParam());
  EventLog log(filter);
  const auto broken = Sample::Icosphere(1);
  broken->GetPoints()->SetPoint(3, vtkMath::Nan(), 0.0, 0.0);
  filter->SetInputData(broken);
  filter->Update();
  ASSERT_EQ(log.Errors.size(), 1u);
  EXPECT_TRUE(IsInitialized(filter->GetOutput()));
  log.Clear();
  filter->SetInputData(Sample::Icosphere(2));
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  const Filter fresh = MakeFilter(GetParam());
  fresh->Update();
  EXPECT_TRUE(SameImage(fresh->GetOutput(), filter->GetOutput()));
}

INSTANTIATE_TEST_SUITE_P(Methods, MeshSDFUpdates,
  testing::Values(vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::FAST_SWEEPING, vtkMeshSDF::BRUTE_FORCE),
  NameOfMethod);

} // namespace
