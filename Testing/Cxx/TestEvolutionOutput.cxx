// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// EvolutionOutput: states with different polygons as VTK data.

#include "EvolutionOutput.h"

#include "DataChecks.h"
#include "FlowSetups.h"
#include "SurfaceMeasures.h"

#include "Evolution/Remeshers.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{

constexpr std::size_t NoLimit = std::numeric_limits<std::size_t>::max();
constexpr int Steps = 6;
constexpr int RefinedStep = 3;

//------------------------------------------------------------------------------
/// A unit sphere that shrinks by its curvature and is refined on the way.
EvolutionOutput RefinedSphere(std::size_t memoryLimit)
{
  evolving::FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = 0.01;
  options.numberOfSteps = Steps;
  options.remeshingInterval = RefinedStep;
  const auto start = std::make_shared<const evolving::SurfaceMesh>(evolving::icosphere(2));
  const auto refiner = evolving::remeshers::refiner(642);
  return EvolutionOutput(VTK_DOUBLE, false,
    [=](const evolving::Execution& host)
    { return evolving::SurfaceFlow(start, nullptr, refiner, options, host); },
    evolving::publishedIterations(Steps, 0, 1), memoryLimit, {});
}

//------------------------------------------------------------------------------
void ExpectState(vtkPolyData* output, int step)
{
  const vtkIdType points = step < RefinedStep ? 162 : 642;
  EXPECT_EQ(output->GetNumberOfPoints(), points);
  EXPECT_EQ(output->GetNumberOfPolys(), 2 * points - 4);
  EXPECT_EQ(output->GetNumberOfCells(), 2 * points - 4);
  EXPECT_EQ(CountBadEdges(output), 0);
  EXPECT_EQ(EulerCharacteristic(output), 2);
  vtkPointData* arrays = output->GetPointData();
  EXPECT_EQ(arrays->GetNumberOfArrays(), 6);
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    EXPECT_EQ(arrays->GetArray(i)->GetNumberOfTuples(), points) << arrays->GetArrayName(i);
  }
  EXPECT_EQ(FieldValue(output, "Iteration"), static_cast<double>(step));
  EXPECT_NEAR(FieldValue(output, "Area"), AreaOf(output), 1e-9);
  const double radius = std::sqrt(1.0 - 4.0 * FieldValue(output, "Time"));
  EXPECT_NEAR(DistanceFromOrigin(output).Largest, radius, 0.01);
  EXPECT_NEAR(DistanceFromOrigin(output).Smallest, radius, 0.01);
}

//------------------------------------------------------------------------------
TEST(EvolutionOutput, EveryStateHasItsPolygonsInAnyOrder)
{
  for (const std::size_t limit : { NoLimit, std::size_t(0) })
  {
    EvolutionOutput series = RefinedSphere(limit);
    vtkNew<vtkPolyData> output; // of one filter, written again and again
    for (const int step : { 0, 1, 2, 3, 4, 5, 6, 5, 2, 6, 0, 3, 2 })
    {
      SCOPED_TRACE("step " + std::to_string(step));
      const auto i = static_cast<std::size_t>(step);
      series.WriteState(i, output, {});
      ExpectState(output, step);
      EXPECT_EQ(series.Mesh(i, {}).faceCount(), output->GetNumberOfPolys());
      EXPECT_EQ(series.Mesh(i, {}).vertexCount(), output->GetNumberOfPoints());
    }
  }
}

//------------------------------------------------------------------------------
TEST(EvolutionOutput, StatesWithEqualPolygonsShareThem)
{
  for (const std::size_t limit : { NoLimit, std::size_t(0) })
  {
    EvolutionOutput series = RefinedSphere(limit);
    std::vector<vtkSmartPointer<vtkPolyData>> outputs;
    for (std::size_t step = 0; step <= Steps; ++step)
    {
      outputs.push_back(vtkSmartPointer<vtkPolyData>::New());
      series.WriteState(step, outputs.back(), {});
    }
    for (std::size_t step = 1; step <= Steps; ++step)
    {
      EXPECT_EQ(outputs[step]->GetPolys() == outputs[step - 1]->GetPolys(), step != RefinedStep)
        << step;
    }
  }
}

//------------------------------------------------------------------------------
TEST(EvolutionOutput, HistoryHasARowForEveryStep)
{
  const EvolutionOutput series = RefinedSphere(NoLimit);
  vtkNew<vtkTable> history;
  series.WriteHistory(history);
  ASSERT_EQ(history->GetNumberOfRows(), Steps + 1);
  for (int step = 0; step <= Steps; ++step)
  {
    EXPECT_EQ(ValueAt(history, step, "Iteration"), static_cast<double>(step));
  }
  EXPECT_TRUE(IsFinite(history));
}

} // namespace
