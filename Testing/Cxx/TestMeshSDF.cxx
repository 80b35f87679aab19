// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkMeshSDF: are the distances, signs and further arrays right?

#include "FilterRuns.h"
#include "SampleSurfaces.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{

//------------------------------------------------------------------------------
vtkDataArray* Array(vtkImageData* image, const char* name)
{
  return image->GetPointData()->GetArray(name);
}

//------------------------------------------------------------------------------
/// The largest |computed - expected(point)| over all samples, in cells.
double LargestError(
  vtkImageData* image, const std::function<double(const double point[3])>& expected)
{
  vtkDataArray* distance = image->GetPointData()->GetScalars();
  double largest = 0.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double error = std::abs(distance->GetTuple1(i) - expected(image->GetPoint(i)));
    largest = std::max(largest, error);
  }
  return largest / image->GetSpacing()[0];
}

//------------------------------------------------------------------------------
/// The exact signed distance of the cube [-1, 1]^3.
double CubeDistance(const double p[3])
{
  double outside[3];
  double inside = -VTK_DOUBLE_MAX;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double q = std::abs(p[axis]) - 1.0;
    outside[axis] = std::max(q, 0.0);
    inside = std::max(inside, q);
  }
  return vtkMath::Norm(outside) + std::min(inside, 0.0);
}

//------------------------------------------------------------------------------
TEST(MeshSDF, BruteForceIsExactForACube)
{
  const auto image =
    Distance(Sample::Box(1), 21, [](vtkMeshSDF* filter) { filter->SetMethodToBruteForce(); });
  EXPECT_LT(LargestError(image, CubeDistance), 1e-5);
}

//------------------------------------------------------------------------------
TEST(MeshSDF, ClosestPointIsNearlyExactForACube)
{
  EXPECT_LT(LargestError(Distance(Sample::Box(1), 21), CubeDistance), 0.02);
}

//------------------------------------------------------------------------------
TEST(MeshSDF, FastSweepingIsOfFirstOrderForACube)
{
  const auto meanSquare = [](int n)
  {
    const auto image =
      Distance(Sample::Box(1), n, [](vtkMeshSDF* filter) { filter->SetMethodToFastSweeping(); });
    double sum = 0.0;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double d = image->GetPointData()->GetScalars()->GetTuple1(i);
      sum += std::pow(d - CubeDistance(image->GetPoint(i)), 2);
    }
    return sum / static_cast<double>(image->GetNumberOfPoints());
  };
  // Like h^2: a fourth for half the cells.
  EXPECT_LT(meanSquare(65), 0.35 * meanSquare(33));
  EXPECT_LT(meanSquare(33), 0.01);
}

//------------------------------------------------------------------------------
TEST(MeshSDF, DistanceToAnIcosphereLiesBetweenThatToItsTwoSpheres)
{
  const auto surface = Sample::Icosphere(2, 2.0);
  double inner = 2.0;
  for (const Sample::Polygon& face : Sample::PolygonsOf(surface))
  {
    double center[3] = { 0, 0, 0 };
    for (const vtkIdType id : face)
    {
      vtkMath::Add(center, surface->GetPoint(id), center);
    }
    inner = std::min(inner, vtkMath::Norm(center) / 3.0);
  }
  ASSERT_LT(inner, 1.99);
  const auto image = Distance(surface, 32);
  vtkDataArray* distance = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double radius = vtkMath::Norm(image->GetPoint(i));
    ASSERT_GE(distance->GetTuple1(i), radius - 2.0 - 1e-6);
    ASSERT_LE(distance->GetTuple1(i), radius - inner + 1e-3);
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDF, ClosestPointAgreesWithBruteForceOnTheBunny)
{
  const auto bunny = Sample::Read("bunny.ply");
  const auto fast = Distance(bunny, 40);
  const auto exact =
    Distance(bunny, 40, [](vtkMeshSDF* filter) { filter->SetMethodToBruteForce(); });
  vtkDataArray* d = exact->GetPointData()->GetScalars();
  vtkDataArray* found = fast->GetPointData()->GetScalars();
  const double cell = exact->GetSpacing()[0];
  for (vtkIdType i = 0; i < d->GetNumberOfTuples(); ++i)
  {
    ASSERT_NEAR(found->GetTuple1(i), d->GetTuple1(i), 0.1 * cell);
    ASSERT_EQ(found->GetTuple1(i) < 0.0, d->GetTuple1(i) < 0.0) << "at sample " << i;
    if (std::abs(d->GetTuple1(i)) < cell)
    {
      ASSERT_NEAR(found->GetTuple1(i), d->GetTuple1(i), 1e-5 * cell);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDF, TheDistanceIsTheActiveScalars)
{
  const auto image = Distance(Sample::Icosphere(1), 8);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  ASSERT_NE(scalars, nullptr);
  EXPECT_STREQ(scalars->GetName(), "SignedDistance");
  EXPECT_EQ(scalars->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(scalars->GetNumberOfTuples(), 512);
  EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 1);
}

//------------------------------------------------------------------------------
TEST(MeshSDF, ClosestPointsCellsAndGradientsFitTheDistance)
{
  const auto surface = Sample::Box(3);
  const auto image = Distance(surface, 15,
    [](vtkMeshSDF* filter)
    {
      filter->SetMethodToBruteForce();
      filter->ComputeClosestPointOn();
      filter->ComputeClosestCellIdOn();
      filter->ComputeGradientOn();
    });
  vtkDataArray* distance = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double closest[3];
    double offset[3];
    image->GetPoint(i, p);
    Array(image, "ClosestPoint")->GetTuple(i, closest);
    vtkMath::Subtract(p, closest, offset);
    const double d = distance->GetTuple1(i);
    ASSERT_NEAR(vtkMath::Norm(offset), std::abs(d), 1e-6);
    const auto cell = static_cast<vtkIdType>(Array(image, "ClosestCellId")->GetTuple1(i));
    ASSERT_GE(cell, 0);
    ASSERT_LT(cell, surface->GetNumberOfCells());
    double bounds[6];
    surface->GetCellBounds(cell, bounds);
    double tolerance[3] = { 1e-6, 1e-6, 1e-6 };
    ASSERT_TRUE(vtkMath::PointIsWithinBounds(closest, bounds, tolerance));
    double gradient[3];
    Array(image, "Gradient")->GetTuple(i, gradient);
    const double length = vtkMath::Norm(gradient);
    ASSERT_TRUE(length == 0.0 || std::abs(length - 1.0) < 1e-5) << length;
    if (std::abs(d) > 1e-3 && d > 0.0)
    {
      ASSERT_NEAR(vtkMath::Dot(gradient, offset), d, 1e-5);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDF, BandWidthCutsTheDistanceOff)
{
  const auto image =
    Distance(Sample::Icosphere(2), 24, [](vtkMeshSDF* filter) { filter->SetBandWidth(2.0); });
  const auto whole = Distance(Sample::Icosphere(2), 24);
  const double band = 2.0 * image->GetSpacing()[0];
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double d = whole->GetPointData()->GetScalars()->GetTuple1(i);
    const double expected = std::clamp(d, -band, band);
    ASSERT_NEAR(image->GetPointData()->GetScalars()->GetTuple1(i), expected, 1e-2 * band);
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDF, SmoothingKeepsAPlaneAndRoundsACorner)
{
  const auto sharp = Distance(Sample::Box(1), 25);
  const auto smooth =
    Distance(Sample::Box(1), 25, [](vtkMeshSDF* filter) { filter->SetSmoothingSigma(1.0); });
  const double center[3] = { 0.0, 0.0, 0.0 };
  const auto difference = [&](const double at[3])
  {
    const vtkIdType i = sharp->FindPoint(const_cast<double*>(at));
    return smooth->GetPointData()->GetScalars()->GetTuple1(i) -
      sharp->GetPointData()->GetScalars()->GetTuple1(i);
  };
  const double side[3] = { 1.0, 0.0, 0.0 };
  EXPECT_NEAR(difference(side), 0.0, 1e-3);
  // The distance has a convex kink along the diagonals inside: its mean there is larger.
  EXPECT_GT(difference(center), 0.05);
}

} // namespace
