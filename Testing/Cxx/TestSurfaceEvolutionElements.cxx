// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution: no step turns an element over, and none ends the run for fear of it.

#include "DataChecks.h"
#include "EventLog.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"

#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"

#include <gtest/gtest.h>

namespace
{

using Sample::Point;
using Sample::Polygon;

//------------------------------------------------------------------------------
Point Minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

//------------------------------------------------------------------------------
Point Normal(const std::vector<Point>& points, const Polygon& triangle)
{
  const Point a = Minus(points[triangle[1]], points[triangle[0]]);
  const Point b = Minus(points[triangle[2]], points[triangle[0]]);
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

//------------------------------------------------------------------------------
/// The triangles that turned by more than a right angle in a step, summed over all steps.
int TurnedTriangles(vtkSurfaceEvolution* filter)
{
  filter->UpdateTimeStep(0.0);
  const std::vector<Polygon> triangles = Sample::PolygonsOf(filter->GetOutput());
  std::vector<Point> before = Sample::CoordinatesOf(filter->GetOutput());
  int turned = 0;
  for (int step = 1; step <= filter->GetNumberOfSteps(); ++step)
  {
    filter->UpdateTimeStep(step * filter->GetTimeStep());
    const std::vector<Point> points = Sample::CoordinatesOf(filter->GetOutput());
    for (const Polygon& triangle : triangles)
    {
      const Point a = Normal(before, triangle);
      const Point b = Normal(points, triangle);
      turned += a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < 0.0;
    }
    before = points;
  }
  return turned;
}

//------------------------------------------------------------------------------
/// A file's surface with double coordinates: rounding to floats would turn slivers.
Sample::Surface ReadDouble(const std::string& name)
{
  const auto surface = Sample::Read(name);
  return Sample::Make(Sample::CoordinatesOf(surface), Sample::PolygonsOf(surface));
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionElements, TheBunnysEarsWaitAndTheRestShrinks)
{
  for (const double rate : { 0.0, 5.0 })
  {
    SCOPED_TRACE(rate);
    vtkNew<vtkSurfaceEvolution> filter;
    EventLog log(filter);
    filter->SetInputData(ReadDouble("bunny.ply"));
    filter->SetRemeshingToOff();
    filter->SetCurvatureSpeed(1.0);
    filter->SetTimeStep(0.002); // about a mean co-volume
    filter->SetNumberOfSteps(15);
    filter->SetVolumeRedistribution(rate);
    EXPECT_EQ(TurnedTriangles(filter), 0);
    EXPECT_TRUE(log.Errors.empty());
    EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 15.0);
    const double after = FieldValue(filter->GetOutput(), "Area");
    filter->UpdateTimeStep(0.0);
    EXPECT_LT(after, 0.45 * FieldValue(filter->GetOutput(), "Area"));
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionElements, AnIcosphereGoesOntoTheArc)
{
  const auto arc = ReadDouble("arc.vtk");
  double center[3];
  arc->GetCenter(center);
  vtkNew<vtkMeshSDF> distance;
  distance->SetInputData(arc);
  distance->SetSampleDimensions(60, 60, 60);
  distance->SetPadding(0.3);
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  filter->SetInputData(
    0, Sample::Icosphere(4, 0.55 * arc->GetLength(), { center[0], center[1], center[2] }));
  filter->SetInputConnection(1, distance->GetOutputPort());
  filter->SetRemeshingToOff();
  filter->SetConvergenceTolerance(0.0);
  filter->SetTimeStep(0.03);
  filter->SetNumberOfSteps(150);
  filter->SetCurvatureSpeed(0.1);
  filter->SetAdvectionBalance(0.2);
  EXPECT_EQ(TurnedTriangles(filter), 0);
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 150.0);
  EXPECT_LT(FieldValue(filter->GetOutput(), "MeanDistance"), 0.02 * arc->GetLength());
}

} // namespace
