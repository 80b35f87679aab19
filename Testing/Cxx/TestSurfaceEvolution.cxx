// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution: is the flow right, and are its arrays and its history?

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using Names = std::vector<std::string>;

//------------------------------------------------------------------------------
/// Error (6.1) of a shrinking unit sphere, with the co-volumes of each step's start.
double ShrinkingSphereError(int level, double timeStep, int steps)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpCurvatureFlow(filter, Sample::Icosphere(level), timeStep, steps);
  double sum = 0.0;
  std::vector<double> weights;
  for (int k = 0; k <= steps; ++k)
  {
    filter->UpdateTimeStep(k * timeStep);
    vtkPolyData* output = filter->GetOutput();
    const double radius = std::sqrt(1.0 - 4.0 * k * timeStep);
    vtkDataArray* coVolume = output->GetPointData()->GetArray("CoVolume");
    for (vtkIdType i = 0; k > 0 && i < output->GetNumberOfPoints(); ++i)
    {
      const double off = vtkMath::Norm(output->GetPoint(i)) - radius;
      sum += timeStep * off * off * weights[static_cast<std::size_t>(i)];
    }
    weights.resize(static_cast<std::size_t>(output->GetNumberOfPoints()));
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      weights[i] = coVolume->GetTuple1(static_cast<vtkIdType>(i));
    }
  }
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
  return std::sqrt(sum);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolution, ShrinkingSphereHasTheErrorsOfTheThesis)
{
  // Table 6.1 of the thesis, without redistribution.
  EXPECT_NEAR(ShrinkingSphereError(1, 0.01, 6), 0.00306693, 1e-3 * 0.00306693);
  EXPECT_NEAR(ShrinkingSphereError(2, 0.0025, 24), 0.000867587, 1e-3 * 0.000867587);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolution, QuadsShrinkAsTheyShould)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpCurvatureFlow(filter, Sample::CubeSphere(12), 0.001, 60);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 6 * 12 * 12);
  EXPECT_EQ(filter->GetOutput()->GetMaxCellSize(), 4);
  const Range radius = DistanceFromOrigin(filter->GetOutput());
  EXPECT_NEAR(radius.Smallest, std::sqrt(1.0 - 4.0 * 0.06), 0.005);
  EXPECT_NEAR(radius.Largest, std::sqrt(1.0 - 4.0 * 0.06), 0.005);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolution, RelativeUnitsScaleWithTheModel)
{
  const auto relative = [](double scale)
  {
    vtkNew<vtkSurfaceEvolution> filter;
    filter->SetInputData(Sample::Icosphere(2, scale));
    filter->SetTimeStep(0.1);
    filter->SetNumberOfSteps(5);
    filter->Update();
    return DistanceFromOrigin(filter->GetOutput()).Largest / scale;
  };
  EXPECT_NEAR(relative(1e-3), relative(1.0), 1e-7);
  EXPECT_NEAR(relative(1e5), relative(1.0), 1e-7);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolution, ADistanceFieldAttractsTheSurface)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpAttraction(filter, Sample::Icosphere(3, 1.5));
  filter->Update();
  const Range radius = DistanceFromOrigin(filter->GetOutput());
  // The distance decreases like exp(-C T) = exp(-4): 0.5 to 0.009.
  EXPECT_GT(radius.Smallest, 0.99);
  EXPECT_LT(radius.Largest, 1.02);
  EXPECT_NEAR(FieldValue(filter->GetOutput(), "MaxDistance"), radius.Largest - 1.0, 0.01);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolution, ADistanceFieldAttractsFromInside)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpAttraction(filter, Sample::Icosphere(3, 0.5));
  filter->SetNumberOfSteps(60);
  filter->Update();
  EXPECT_NEAR(DistanceFromOrigin(filter->GetOutput()).Smallest, 1.0, 0.03);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolution, AFixedBoundaryStays)
{
  // A bump over a square whose border lies in the plane z = 0.
  const auto bump = Sample::Mapped(Sample::Sheet(12),
    [](const Sample::Point& p) -> Sample::Point {
      return { p[0], p[1], (1.0 - p[0] * p[0]) * (1.0 - p[1] * p[1]) };
    });
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpCurvatureFlow(filter, bump, 0.05, 60);
  filter->Update();
  const auto isOnBorder = [](const double p[3])
  { return std::abs(std::abs(p[0]) - 1.0) < 1e-12 || std::abs(std::abs(p[1]) - 1.0) < 1e-12; };
  for (vtkIdType i = 0; i < bump->GetNumberOfPoints(); ++i)
  {
    double before[3];
    double after[3];
    bump->GetPoint(i, before);
    filter->GetOutput()->GetPoint(i, after);
    if (isOnBorder(before))
    {
      ASSERT_TRUE(std::equal(before, before + 3, after)) << "point " << i;
    }
    // The minimal surface in a plane border is the plane.
    ASSERT_NEAR(after[2], 0.0, 0.01);
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolution, ASoupIsWelded)
{
  const auto welded = Sample::Icosphere(1);
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpCurvatureFlow(filter, Sample::Soup(welded), 0.01, 6);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 42);
  EXPECT_EQ(CountBadEdges(filter->GetOutput()), 0);
  EXPECT_NEAR(DistanceFromOrigin(filter->GetOutput()).Largest, std::sqrt(0.76), 0.01);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolution, AnInsideOutStartIsTurned)
{
  const auto sphere = Sample::Icosphere(2, 1.5);
  std::vector<Sample::Polygon> polygons = Sample::PolygonsOf(sphere);
  for (Sample::Polygon& polygon : polygons)
  {
    std::reverse(polygon.begin(), polygon.end());
  }
  vtkNew<vtkSurfaceEvolution> turned;
  SetUpAttraction(turned, Sample::Make(Sample::CoordinatesOf(sphere), polygons));
  turned->SetAdvectionBalance(0.5);
  turned->Update();
  EXPECT_NEAR(DistanceFromOrigin(turned->GetOutput()).Largest, 1.0, 0.03);
  EXPECT_GT(VolumeOf(turned->GetOutput()), 3.5);
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolution, PointsAreWrittenAsTheyWereRead)
{
  const auto precise = Sample::Icosphere(1);
  const auto single =
    Sample::Make(Sample::CoordinatesOf(precise), Sample::PolygonsOf(precise), VTK_FLOAT);
  for (vtkPolyData* start : { precise.Get(), single.Get() })
  {
    vtkNew<vtkSurfaceEvolution> filter;
    SetUpCurvatureFlow(filter, start, 0.01, 2);
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetPoints()->GetDataType(), start->GetPoints()->GetDataType());
  }
}

} // namespace
