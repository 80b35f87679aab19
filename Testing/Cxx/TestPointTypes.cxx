// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What is said of a surface holds for the points that are handed out, float or double; and where
// floats are too far apart for its elements, the points are double.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "EventLog.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using Sample::Point;
using Sample::Surface;

const Point Far = { 6e5, 5e6, 700.0 };

//------------------------------------------------------------------------------
Surface FloatSphere(int level, double radius, const Point& center)
{
  const Surface sphere = Sample::Icosphere(level, radius, center);
  return Sample::Make(Sample::CoordinatesOf(sphere), Sample::PolygonsOf(sphere), VTK_FLOAT);
}

//------------------------------------------------------------------------------
/// x - center: exact in an image of few samples.
vtkSmartPointer<vtkImageData> PlaneImage(const Point& center)
{
  const auto image = Sample::SphereImage(17, 2.0, 1.0);
  vtkNew<vtkFloatArray> values;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(static_cast<float>(image->GetPoint(i)[0]));
  }
  image->GetPointData()->SetScalars(values);
  image->SetOrigin(center[0] - 2.0, center[1] - 2.0, center[2] - 2.0);
  return image;
}

//------------------------------------------------------------------------------
int TypeOf(vtkPolyData* surface)
{
  return surface->GetPoints()->GetDataType();
}

//------------------------------------------------------------------------------
/// Is what the field data say true of the points of the output?
void ExpectTrueNumbers(vtkPolyData* output)
{
  EXPECT_NEAR(FieldValue(output, "MinAngle"), SmallestAngleOf(output), 1e-9);
  EXPECT_NEAR(FieldValue(output, "Area") / AreaOf(output), 1.0, 1e-12);
  // Far from the origin a volume measured from there is worth little.
  const Surface near = Sample::Mapped(output,
    [](const Point& p) -> Point {
      return { p[0] - 10000.0, p[1], p[2] };
    });
  EXPECT_NEAR(FieldValue(output, "Volume") / VolumeOf(near), 1.0, 1e-12);
}

//------------------------------------------------------------------------------
TEST(PointTypes, FloatsThatHoldAreKeptAndMeasuredAsTheyAre)
{
  const Point center = { 10000.0, 0.0, 0.0 };
  for (const int remeshing : { vtkSurfaceEvolution::OFF, vtkSurfaceEvolution::UNIFORM })
  {
    vtkNew<vtkSurfaceEvolution> filter;
    EventLog log(filter);
    SetUpCurvatureFlow(filter, FloatSphere(2, 1.0, center), 0.01, 3);
    filter->SetRemeshing(remeshing);
    for (int step = 0; step <= 3; ++step)
    {
      filter->UpdateTimeStep(0.01 * step);
      EXPECT_EQ(TypeOf(filter->GetOutput()), VTK_FLOAT);
      ExpectTrueNumbers(filter->GetOutput());
      EXPECT_EQ(
        ValueAt(HistoryOf(filter), step, "MinAngle"), FieldValue(filter->GetOutput(), "MinAngle"));
      EXPECT_EQ(ValueAt(HistoryOf(filter), step, "Area"), FieldValue(filter->GetOutput(), "Area"));
    }
    EXPECT_TRUE(log.Errors.empty());
    EXPECT_TRUE(log.Warnings.empty());
    EXPECT_EQ(HistoryOf(filter)->GetNumberOfRows(), 4);
  }
}

//------------------------------------------------------------------------------
/// A point that is rounded lies half a float's step off along each axis, here 2^-11.
TEST(PointTypes, DistancesAreThoseOfTheArrayThatIsHandedOut)
{
  const Point center = { 10000.0, 0.0, 0.0 };
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(0, FloatSphere(2, 1.0, center));
  filter->SetInputData(1, PlaneImage(center));
  filter->SetTimeStep(0.01);
  filter->SetNumberOfSteps(2);
  filter->SetCurvatureSpeed(0.01);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(TypeOf(output), VTK_FLOAT);
  vtkDataArray* distances = output->GetPointData()->GetArray("SignedDistance");
  double largest = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double distance = distances->GetComponent(i, 0);
    EXPECT_NEAR(distance, output->GetPoint(i)[0] - center[0], 0x1p-11);
    largest = std::max(largest, std::abs(distance));
  }
  EXPECT_EQ(FieldValue(output, "MaxDistance"), largest);
}

//------------------------------------------------------------------------------
/// The case of a city model in a national grid: floats there are half a unit apart.
TEST(PointTypes, WhereFloatsAreTooFarApartAnEvolutionHandsOutDoubles)
{
  for (const int remeshing : { vtkSurfaceEvolution::OFF, vtkSurfaceEvolution::UNIFORM })
  {
    vtkNew<vtkSurfaceEvolution> filter;
    EventLog log(filter);
    SetUpCurvatureFlow(filter, FloatSphere(3, 10.0, Far), 0.1, 5);
    filter->SetRemeshing(remeshing);
    for (int step = 5; step >= 0; --step)
    {
      filter->UpdateTimeStep(0.1 * step);
      EXPECT_EQ(TypeOf(filter->GetOutput()), VTK_DOUBLE);
      EXPECT_NEAR(
        FieldValue(filter->GetOutput(), "MinAngle"), SmallestAngleOf(filter->GetOutput()), 1e-6);
    }
    ASSERT_EQ(log.Warnings.size(), 1u);
    EXPECT_TRUE(IsOneSentence(log.Warnings.front()));
    EXPECT_NE(log.Warnings.front().find("double"), std::string::npos);
    EXPECT_TRUE(log.Errors.empty());
  }
}

//------------------------------------------------------------------------------
TEST(PointTypes, AStartThatDoesNotMoveKeepsItsFloats)
{
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  SetUpCurvatureFlow(filter, FloatSphere(3, 10.0, Far), 0.1, 0);
  filter->Update();
  EXPECT_EQ(TypeOf(filter->GetOutput()), VTK_FLOAT);
  EXPECT_TRUE(log.Warnings.empty());
}

//------------------------------------------------------------------------------
TEST(PointTypes, ARedistributionFarAwayHandsOutDoubles)
{
  vtkNew<vtkTangentialRedistribution> filter;
  EventLog log(filter);
  const Surface input = FloatSphere(3, 10.0, Far);
  filter->SetInputData(input);
  filter->SetNumberOfSteps(10);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_EQ(TypeOf(filter->GetOutput()), VTK_DOUBLE);
  EXPECT_EQ(TypeOf(input), VTK_FLOAT);
  ASSERT_EQ(log.Warnings.size(), 1u);
  EXPECT_TRUE(IsOneSentence(log.Warnings.front()));
  // PreserveShape: on the input to rounding of doubles at 5e6, where floats are 0.5 apart.
  EXPECT_LT(LargestDistance(filter->GetOutput(), input), 1e-6);
}

//------------------------------------------------------------------------------
TEST(PointTypes, ARedistributionNearTheOriginKeepsFloats)
{
  vtkNew<vtkTangentialRedistribution> filter;
  EventLog log(filter);
  filter->SetInputData(FloatSphere(3, 1.0, { 100.0, 0.0, 0.0 }));
  filter->SetNumberOfSteps(5);
  filter->Update();
  EXPECT_EQ(TypeOf(filter->GetOutput()), VTK_FLOAT);
  EXPECT_TRUE(log.Warnings.empty());
}

} // namespace
