// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Bad inputs: the documented result, or one sentence and empty outputs; never a crash or a NaN.

#include "DataChecks.h"
#include "DirtySurfaces.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"

#include "vtkDistanceHierarchy.h"
#include "vtkMeshSDF.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

namespace
{

using Filter = vtkSmartPointer<vtkAlgorithm>;

//------------------------------------------------------------------------------
Filter MakeDistance()
{
  auto filter = vtkSmartPointer<vtkMeshSDF>::New();
  filter->SetSampleDimensions(12, 12, 12);
  filter->ComputeGradientOn();
  filter->ComputeClosestPointOn();
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeEvolution()
{
  auto filter = vtkSmartPointer<vtkSurfaceEvolution>::New();
  filter->SetNumberOfSteps(3);
  filter->SetTimeStep(0.01);
  filter->SetVolumeRedistribution(1.0);
  filter->SetAngleRedistribution(1.0);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeRedistribution()
{
  auto filter = vtkSmartPointer<vtkTangentialRedistribution>::New();
  filter->SetNumberOfSteps(3);
  return filter;
}

//------------------------------------------------------------------------------
Filter MakeWrap()
{
  auto filter = vtkSmartPointer<vtkShrinkWrap>::New();
  filter->SetSampleDimensions(24, 24, 24);
  filter->SetNumberOfSteps(15);
  return filter;
}

//------------------------------------------------------------------------------
/// Gives an input to a filter; a wrap gets edges that fit the coarse grid.
void SetInput(vtkAlgorithm* filter, vtkPolyData* surface)
{
  filter->SetInputDataObject(0, surface);
  if (auto* wrap = vtkShrinkWrap::SafeDownCast(filter))
  {
    const double size = surface->GetLength();
    wrap->SetTargetEdgeLength(std::isfinite(size) ? 0.05 * size : 0.0);
  }
}

//------------------------------------------------------------------------------
Filter MakeHierarchy()
{
  auto filter = vtkSmartPointer<vtkDistanceHierarchy>::New();
  filter->SetStructureToOctree();
  filter->SetSampleDimensions(12, 12, 12);
  return filter;
}

//------------------------------------------------------------------------------
struct FilterCase
{
  const char* Name;
  Filter (*Make)();
  Answer DirtySurface::*Answers;
};

const FilterCase Distance = { "Distance", MakeDistance, &DirtySurface::Distance };
const FilterCase Evolution = { "Evolution", MakeEvolution, &DirtySurface::Evolution };
const FilterCase Redistribution = { "Redistribution", MakeRedistribution,
  &DirtySurface::Redistribution };
const FilterCase Wrap = { "Wrap", MakeWrap, &DirtySurface::Wrap };
const FilterCase Hierarchy = { "Hierarchy", MakeHierarchy, &DirtySurface::Hierarchy };

//------------------------------------------------------------------------------
vtkIdType PointsOf(vtkAlgorithm* filter)
{
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
void ExpectAnswer(vtkAlgorithm* filter, const EventLog& log, Answer answer)
{
  if (answer == Answer::Error)
  {
    ExpectRefusal(filter, log);
    return;
  }
  ASSERT_TRUE(log.Errors.empty()) << log.Errors.front();
  EXPECT_EQ(PointsOf(filter) == 0, answer == Answer::Empty);
  EXPECT_TRUE(IsFinite(filter->GetOutputDataObject(0)));
}

//------------------------------------------------------------------------------
class Inputs : public testing::TestWithParam<std::tuple<FilterCase, DirtySurface>>
{
};

TEST_P(Inputs, AreAnswered)
{
  const auto& [filterCase, surface] = GetParam();
  const Filter filter = filterCase.Make();
  EventLog log(filter);
  SetInput(filter, surface.Make());
  filter->Update();
  ExpectAnswer(filter, log, surface.*filterCase.Answers);
  EXPECT_TRUE(log.Others.empty()) << log.Others.front();
  // The same again, and then something good: nothing is left of what went before.
  log.Clear();
  SetInput(filter, Sample::Icosphere(2));
  filter->Update();
  ExpectAnswer(filter, log, Answer::Result);
  log.Clear();
  SetInput(filter, surface.Make());
  filter->Update();
  ExpectAnswer(filter, log, surface.*filterCase.Answers);
}

INSTANTIATE_TEST_SUITE_P(All, Inputs,
  testing::Combine(testing::Values(Distance, Evolution, Redistribution, Wrap, Hierarchy),
    testing::ValuesIn(DirtySurfaces())),
  [](const testing::TestParamInfo<std::tuple<FilterCase, DirtySurface>>& info)
  { return std::string(std::get<0>(info.param).Name) + "_" + std::get<1>(info.param).Name; });

//------------------------------------------------------------------------------
class AnyFilter : public testing::TestWithParam<FilterCase>
{
};

TEST_P(AnyFilter, WithoutInputHasEmptyOutput)
{
  const Filter filter = GetParam().Make();
  EventLog log(filter);
  filter->Update();
  EXPECT_EQ(PointsOf(filter), 0);
  EXPECT_LE(log.Errors.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(All, AnyFilter,
  testing::Values(Distance, Evolution, Redistribution, Wrap, Hierarchy),
  [](const testing::TestParamInfo<FilterCase>& info) { return info.param.Name; });

} // namespace
