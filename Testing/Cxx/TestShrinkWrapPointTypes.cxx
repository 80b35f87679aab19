// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkShrinkWrap hands out doubles where floats would spoil its result.

#include "DataChecks.h"
#include "EventLog.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace
{

using Sample::Point;
using Sample::Surface;
using Vector = Eigen::Vector3d;

//------------------------------------------------------------------------------
int TypeOf(vtkPolyData* surface)
{
  return surface->GetPoints()->GetDataType();
}

//------------------------------------------------------------------------------
TEST(ShrinkWrapPointTypes, AWrapFarAwayHandsOutDoublesInAllSteps)
{
  vtkNew<vtkShrinkWrap> filter;
  EventLog log(filter);
  // In the coordinates of a national grid.
  const Surface sphere = Sample::Icosphere(3, 100.0, { 6e5, 5e6, 700.0 });
  filter->SetInputData(
    Sample::Make(Sample::CoordinatesOf(sphere), Sample::PolygonsOf(sphere), VTK_FLOAT));
  filter->SetSampleDimensions(24, 24, 24);
  filter->SetTargetEdgeLength(15.0);
  filter->OutputStepsOn();
  filter->UpdateInformation();
  for (const double time : { 1e9, 0.0 })
  {
    filter->UpdateTimeStep(time);
    EXPECT_EQ(TypeOf(filter->GetOutput()), VTK_DOUBLE);
    EXPECT_GT(SmallestAngleOf(filter->GetOutput()), 0.0);
  }
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_EQ(
    std::count_if(log.Warnings.begin(), log.Warnings.end(),
      [](const std::string& sentence) { return sentence.find("double") != std::string::npos; }),
    1);
}

//------------------------------------------------------------------------------
/// Bars of length 1 across each other, .02 thick, as floats: thinner than the wrap's triangles.
Surface Bars(int number, unsigned int seed)
{
  std::mt19937 random(seed);
  const auto next = [&random]() { return static_cast<double>(random()) / 4294967296.0; };
  const auto vector = [&next](double scale, double shift)
  {
    const double x = scale * next() + shift;
    const double y = scale * next() + shift;
    return Vector(x, y, scale * next() + shift);
  };
  std::vector<Point> points;
  std::vector<Sample::Polygon> faces;
  for (int bar = 0; bar < number; ++bar)
  {
    const Vector middle = vector(0.8, 0.0);
    const Vector along = vector(1.0, -0.5).normalized();
    const Vector across = along.cross(vector(1.0, -0.5)).normalized();
    const Vector up = along.cross(across);
    const auto base = static_cast<vtkIdType>(points.size());
    for (int i = 0; i < 8; ++i)
    {
      const Vector p = middle + ((i & 1) - 0.5) * along + 0.02 * (((i >> 1) & 1) - 0.5) * across +
        0.02 * ((i >> 2) - 0.5) * up;
      points.push_back({ p.x(), p.y(), p.z() });
    }
    for (const Sample::Polygon& side : std::vector<Sample::Polygon>{ { 0, 2, 3, 1 }, { 4, 5, 7, 6 },
           { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
    {
      faces.push_back({ base + side[0], base + side[1], base + side[2], base + side[3] });
    }
  }
  return Sample::Make(points, faces, VTK_FLOAT);
}

//------------------------------------------------------------------------------
/// Rounded to float this result had five pairs, and the advice to use a smaller edge.
TEST(ShrinkWrapPointTypes, AWrapThatFloatsWouldMakeIntersectHandsOutDoubles)
{
  vtkNew<vtkShrinkWrap> filter;
  EventLog log(filter);
  filter->SetInputData(Bars(6, 2));
  filter->SetSampleDimensions(64, 64, 64);
  filter->SetTargetEdgeLength(0.03);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(FieldValue(output, "SelfIntersections"), 0.0);
  const auto speaksOfDoubles = [](const std::string& sentence)
  { return sentence.find("double") != std::string::npos; };
  EXPECT_EQ(std::count_if(log.Warnings.begin(), log.Warnings.end(), speaksOfDoubles),
    TypeOf(output) == VTK_DOUBLE ? 1 : 0);
  EXPECT_NEAR(FieldValue(output, "MinAngle"), SmallestAngleOf(output), 1e-9);
}

} // namespace
