// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkMeshSDF: the same surface as triangles, quads, polygons, strips, floats, far away.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "SampleSurfaces.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Distance(vtkPolyData* surface, int n = 16)
{
  vtkNew<vtkMeshSDF> filter;
  filter->SetInputData(surface);
  filter->SetSampleDimensions(n, n, n);
  filter->SetMethodToBruteForce();
  filter->ComputeClosestCellIdOn();
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
double LargestDifference(vtkImageData* a, vtkImageData* b)
{
  vtkDataArray* p = a->GetPointData()->GetScalars();
  vtkDataArray* q = b->GetPointData()->GetScalars();
  EXPECT_EQ(p->GetNumberOfTuples(), q->GetNumberOfTuples());
  double largest = 0.0;
  for (vtkIdType i = 0; i < p->GetNumberOfTuples(); ++i)
  {
    largest = std::max(largest, std::abs(p->GetTuple1(i) - q->GetTuple1(i)));
  }
  return largest;
}

//------------------------------------------------------------------------------
double At(vtkImageData* image, double x, double y, double z)
{
  double p[3] = { x, y, z };
  return image->GetPointData()->GetScalars()->GetTuple1(image->FindPoint(p));
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, QuadsAndTheirTrianglesAreTheSameSurface)
{
  const auto quads = Sample::Box(4);
  EXPECT_LT(LargestDifference(Distance(quads), Distance(Sample::Triangulated(quads))), 1e-6);
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, AStripIsItsTriangles)
{
  // A tetrahedron as one strip of four triangles: 0 1 2, 1 3 2, 2 3 0, 3 1 0.
  const std::vector<Sample::Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const auto triangles =
    Sample::Make(points, { { 0, 1, 2 }, { 1, 3, 2 }, { 2, 3, 0 }, { 3, 1, 0 } });
  const auto strip = Sample::Make(points, {});
  vtkNew<vtkCellArray> strips;
  const vtkIdType ids[6] = { 0, 1, 2, 3, 0, 1 };
  strips->InsertNextCell(6, ids);
  strip->SetStrips(strips);
  const auto image = Distance(strip);
  EXPECT_TRUE(SameImage(Distance(triangles), image));
  EXPECT_EQ(image->GetPointData()->GetArray("ClosestCellId")->GetRange()[1], 0.0);
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, AConcavePolygonKeepsItsNotch)
{
  // The L-shaped prism [0,3]x[0,3] without (1,3]x(1,3], of height 1; its caps are hexagons.
  const double outline[6][2] = { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } };
  std::vector<Sample::Point> points;
  for (const double z : { 0.0, 1.0 })
  {
    for (const auto& corner : outline)
    {
      points.push_back({ corner[0], corner[1], z });
    }
  }
  // The caps start at different corners, so that a fan about the first one would leave the L.
  std::vector<Sample::Polygon> polygons = { { 5, 4, 3, 2, 1, 0 }, { 7, 8, 9, 10, 11, 6 } };
  for (vtkIdType i = 0; i < 6; ++i)
  {
    const vtkIdType next = (i + 1) % 6;
    polygons.push_back({ i, next, next + 6, i + 6 });
  }
  const auto image = Distance(Sample::Make(points, polygons), 31);
  EXPECT_EQ(FieldValue(image, "SignMethod"), vtkMeshSDF::PSEUDONORMAL);
  const double cell = image->GetSpacing()[0];
  EXPECT_NEAR(At(image, 2.5, 2.5, 0.5), 1.5, cell);
  EXPECT_NEAR(At(image, 0.5, 2.0, 0.5), -0.5, cell);
  EXPECT_NEAR(At(image, 2.0, 0.5, 0.5), -0.5, cell);
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, FloatPointsGiveTheSameToTheirPrecision)
{
  const auto precise = Sample::Icosphere(2);
  const auto single =
    Sample::Make(Sample::CoordinatesOf(precise), Sample::PolygonsOf(precise), VTK_FLOAT);
  ASSERT_EQ(single->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_LT(LargestDifference(Distance(precise), Distance(single)), 1e-6);
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, NothingIsLostFarFromTheOrigin)
{
  const auto here = Distance(Sample::Icosphere(2));
  const auto there = Distance(Sample::Icosphere(2, 1.0, { 1e6, -2e6, 3e6 }));
  EXPECT_LT(LargestDifference(here, there), 1e-6);
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, TheUnitDoesNotMatter)
{
  const auto one = Distance(Sample::Icosphere(2));
  for (const double scale : { 1e-12, 1e12 })
  {
    const auto scaled = Distance(Sample::Icosphere(2, scale));
    const double expected = At(one, 0.0, 0.0, 0.0) * scale;
    EXPECT_NEAR(At(scaled, 0.0, 0.0, 0.0), expected, 1e-5 * scale);
    EXPECT_EQ(FieldValue(scaled, "SignMethod"), vtkMeshSDF::PSEUDONORMAL);
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, PointsWithoutCellsAreAPointSet)
{
  const auto image = Distance(Sample::Make({ { -1, 0, 0 }, { 1, 0, 0 } }, {}), 9);
  vtkDataArray* cells = image->GetPointData()->GetArray("ClosestCellId");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    const double expected = std::hypot(std::abs(p[0]) - 1.0, p[1], p[2]);
    ASSERT_NEAR(image->GetPointData()->GetScalars()->GetTuple1(i), expected, 1e-6);
    if (std::abs(p[0]) > 1e-9)
    {
      ASSERT_EQ(cells->GetTuple1(i), p[0] < 0.0 ? 0.0 : 1.0);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, VerticesLeaveOtherPointsOut)
{
  const auto set = Sample::Make({ { 9, 9, 9 }, { -1, 0, 0 }, { 1, 0, 0 } }, {});
  vtkNew<vtkCellArray> vertices;
  const vtkIdType ids[2] = { 1, 2 };
  vertices->InsertNextCell(1, &ids[0]);
  vertices->InsertNextCell(1, &ids[1]);
  set->SetVerts(vertices);
  EXPECT_TRUE(
    SameImage(Distance(Sample::Make({ { -1, 0, 0 }, { 1, 0, 0 } }, {}), 9), Distance(set, 9)));
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, PointsThatNoFaceUsesDoNotCount)
{
  const auto clean = Sample::Icosphere(1);
  std::vector<Sample::Point> points = Sample::CoordinatesOf(clean);
  points.push_back({ 50.0, 0.0, 0.0 });
  EXPECT_TRUE(
    SameImage(Distance(clean), Distance(Sample::Make(points, Sample::PolygonsOf(clean)))));
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, ASoupIsTheSurfaceItCameFrom)
{
  const auto surface = Sample::Icosphere(2);
  const auto image = Distance(Sample::Soup(surface));
  EXPECT_EQ(FieldValue(image, "SignMethod"), vtkMeshSDF::PSEUDONORMAL);
  EXPECT_TRUE(SameImage(Distance(surface), image));
}

//------------------------------------------------------------------------------
TEST(MeshSDFInputs, ClosestCellsAreNumberedAsInThePolydata)
{
  // Cell ids run over vertices and lines first.
  const auto surface = Sample::Octahedron();
  vtkNew<vtkCellArray> vertices;
  const vtkIdType id = 0;
  vertices->InsertNextCell(1, &id);
  surface->SetVerts(vertices);
  const auto image = Distance(surface);
  const double* range = image->GetPointData()->GetArray("ClosestCellId")->GetRange();
  EXPECT_EQ(range[0], 1.0);
  EXPECT_EQ(range[1], 8.0);
}

} // namespace
