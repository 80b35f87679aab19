// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Polygons of all kinds, which filters cut into triangles: concave, with corners in a row, with
// repeated corners, without area.

#include "DataChecks.h"
#include "EventLog.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using Sample::Point;
using Sample::Polygon;
using Sample::Surface;

/// The corners of an L of area 3 and circumference 8, some in a row.
const std::vector<Point> Corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 },
  { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 }, { 0, 1, 0 } };

//------------------------------------------------------------------------------
/// The L as one polygon, from another corner on.
Polygon OutlineFrom(vtkIdType first)
{
  Polygon outline = { 0, 1, 2, 3, 4, 5, 6, 7 };
  std::rotate(outline.begin(), outline.begin() + first, outline.end());
  return outline;
}

//------------------------------------------------------------------------------
/// The L, cut by hand.
Surface SheetOfTriangles()
{
  return Sample::Make(
    Corners, { { 0, 1, 4 }, { 0, 4, 7 }, { 1, 2, 3 }, { 1, 3, 4 }, { 7, 4, 5 }, { 7, 5, 6 } });
}

//------------------------------------------------------------------------------
/// Between the L and the same one higher up: two concave polygons and eight quads.
Surface Prism(vtkIdType first)
{
  std::vector<Point> points = Corners;
  for (const Point& p : Corners)
  {
    points.push_back({ p[0], p[1], 1.0 });
  }
  Polygon top = OutlineFrom(first);
  Polygon bottom(top.rbegin(), top.rend());
  std::transform(top.begin(), top.end(), top.begin(), [](vtkIdType id) { return id + 8; });
  std::vector<Polygon> polygons = { top, bottom };
  for (vtkIdType k = 0; k < 8; ++k)
  {
    const vtkIdType next = (k + 1) % 8;
    polygons.push_back({ k, next, next + 8, k + 8 });
  }
  return Sample::Make(points, polygons);
}

//------------------------------------------------------------------------------
/// Distances of samples around the L, without sign.
vtkSmartPointer<vtkImageData> DistancesTo(vtkPolyData* surface)
{
  vtkNew<vtkMeshSDF> filter;
  EventLog log(filter);
  filter->SetInputData(surface);
  filter->SetSampleDimensions(17, 17, 9);
  filter->SetModelBounds(-1.0, 3.0, -1.0, 3.0, -1.0, 1.0);
  filter->SetSignToUnsigned();
  filter->Update();
  EXPECT_TRUE(log.Errors.empty()) << log.Errors.front();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
void ExpectSameDistances(vtkPolyData* surface, vtkPolyData* expected)
{
  const auto image = DistancesTo(surface);
  const auto other = DistancesTo(expected);
  vtkDataArray* found = image->GetPointData()->GetScalars();
  vtkDataArray* wanted = other->GetPointData()->GetScalars();
  ASSERT_EQ(found->GetNumberOfTuples(), wanted->GetNumberOfTuples());
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
  {
    ASSERT_NEAR(found->GetTuple1(i), wanted->GetTuple1(i), 1e-6) << "at sample " << i;
  }
}

//------------------------------------------------------------------------------
TEST(PolygonsAsTriangles, ConcaveOnesAreMeasuredRightFromEveryCornerOn)
{
  for (vtkIdType first = 0; first < 8; ++first)
  {
    Polygon outline = OutlineFrom(first);
    ExpectSameDistances(Sample::Make(Corners, { outline }), SheetOfTriangles());
    std::reverse(outline.begin(), outline.end());
    ExpectSameDistances(Sample::Make(Corners, { outline }), SheetOfTriangles());
  }
}

//------------------------------------------------------------------------------
TEST(PolygonsAsTriangles, RepeatedCornersDoNotMatter)
{
  ExpectSameDistances(
    Sample::Make(Corners, { { 0, 1, 1, 2, 3, 3, 3, 4, 5, 6, 7, 0 } }), SheetOfTriangles());
  // The same place under another number.
  std::vector<Point> points = Corners;
  points.push_back(Corners[4]);
  ExpectSameDistances(Sample::Make(points, { { 0, 1, 2, 3, 4, 8, 5, 6, 7 } }), SheetOfTriangles());
}

//------------------------------------------------------------------------------
/// A frame as one polygon, with a slit from the outline to the hole.
TEST(PolygonsAsTriangles, AHoleWithASlitStaysOpen)
{
  const std::vector<Point> points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 },
    { 0.5, 0.5, 0 }, { 0.5, 1.5, 0 }, { 1.5, 1.5, 0 }, { 1.5, 0.5, 0 } };
  ExpectSameDistances(Sample::Make(points, { { 0, 1, 2, 3, 0, 4, 5, 6, 7, 4 } }),
    Sample::Make(points, { { 0, 1, 7, 4 }, { 1, 2, 6, 7 }, { 2, 3, 5, 6 }, { 3, 0, 4, 5 } }));
}

//------------------------------------------------------------------------------
TEST(PolygonsAsTriangles, ThoseWithoutAreaAddNothing)
{
  // In a row, there and back, and one place alone.
  ExpectSameDistances(
    Sample::Make(Corners, { OutlineFrom(0), { 0, 1, 2, 1 }, { 0, 1, 2 }, { 5, 5, 5, 5 } }),
    SheetOfTriangles());
}

//------------------------------------------------------------------------------
TEST(PolygonsAsTriangles, AnEvolutionWithRemeshingStartsFromTheWholeSurface)
{
  for (const vtkIdType first : { 0, 3, 4 })
  {
    vtkNew<vtkSurfaceEvolution> filter;
    EventLog log(filter);
    filter->SetInputData(Prism(first));
    filter->SetRemeshingToUniform();
    filter->SetTargetEdgeLength(0.2);
    filter->SetTimeStep(1e-4);
    filter->SetNumberOfSteps(2);
    filter->UpdateTimeStep(0.0);
    EXPECT_NEAR(AreaOf(filter->GetOutput()), 14.0, 1e-12);
    EXPECT_NEAR(VolumeOf(filter->GetOutput()), 3.0, 1e-12);
    filter->UpdateTimeStep(2e-4);
    EXPECT_TRUE(log.Errors.empty()) << log.Errors.front();
    EXPECT_EQ(CountBadEdges(filter->GetOutput()), 0);
    EXPECT_NEAR(VolumeOf(filter->GetOutput()), 3.0, 0.15);
  }
}

//------------------------------------------------------------------------------
TEST(PolygonsAsTriangles, AWrapHasTheVolumeOfConcaveFaces)
{
  const Surface prism = Prism(3);
  prism->GetPolys()->InsertNextCell({ 0, 1, 2, 1 });     // without area
  prism->GetPolys()->InsertNextCell({ 8, 9, 9, 10, 8 }); // nor this, with repeated corners
  vtkNew<vtkShrinkWrap> filter;
  EventLog log(filter);
  filter->SetInputData(prism);
  filter->SetSampleDimensions(40, 40, 40);
  filter->SetTargetEdgeLength(0.15);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty()) << log.Errors.front();
  EXPECT_EQ(FieldValue(filter->GetOutput(), "IsClosed"), 1.0);
  EXPECT_NEAR(VolumeOf(filter->GetOutput()), 3.0, 0.1);
  EXPECT_LT(FieldValue(filter->GetOutput(), "MaxDistance"), 0.5 * 0.15); // half an edge
}

} // namespace
