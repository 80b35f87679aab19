// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Faces and points that cannot be used: vtkShrinkWrap leaves them out and says so, the other
// filters refuse the input and name the first.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "EventLog.h"
#include "SampleSurfaces.h"

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace
{

using Sample::Surface;

//------------------------------------------------------------------------------
/// A sphere with a stray vertex cell, so that its polygons are the cells from number 1 on.
Surface WithVertex()
{
  const Surface surface = Sample::Icosphere(2);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  surface->SetVerts(vertices);
  return surface;
}

//------------------------------------------------------------------------------
/// Point 7, which six polygons have, at infinity, and a polygon of two corners at the end.
Surface Damaged()
{
  const Surface surface = WithVertex();
  surface->GetPoints()->SetPoint(7, vtkMath::Inf(), 0.0, 0.0);
  surface->GetPolys()->InsertNextCell({ 0, 1 });
  return surface;
}

//------------------------------------------------------------------------------
int FacesWithPoint7()
{
  int count = 0;
  for (const Sample::Polygon& polygon : Sample::PolygonsOf(Sample::Icosphere(2)))
  {
    count += static_cast<int>(std::count(polygon.begin(), polygon.end(), 7));
  }
  return count;
}

//------------------------------------------------------------------------------
/// A short wrap, and what it said.
class Wrap
{
public:
  explicit Wrap(vtkPolyData* input)
    : Log(this->Filter)
  {
    this->Filter->SetInputData(input);
    this->Filter->SetSampleDimensions(24, 24, 24);
    this->Filter->SetTargetEdgeLength(0.25);
    this->Filter->Update();
  }

  void ExpectLeftOut(const std::string& beginning) const
  {
    ASSERT_TRUE(this->Log.Errors.empty()) << this->Log.Errors.front();
    ASSERT_FALSE(this->Log.Warnings.empty());
    EXPECT_TRUE(IsOneSentence(this->Log.Warnings.front()));
    EXPECT_EQ(this->Log.Warnings.front().rfind(beginning, 0), 0u) << this->Log.Warnings.front();
    vtkPolyData* output = this->Filter->GetOutput();
    EXPECT_EQ(FieldText(output, "Shortcomings"), this->Log.Warnings.front());
    EXPECT_EQ(FieldValue(output, "IsClosed"), 1.0);
    EXPECT_TRUE(IsFinite(output));
    const Range radius = DistanceFromOrigin(output);
    EXPECT_NEAR(radius.Smallest, 1.0, 0.2);
    EXPECT_NEAR(radius.Largest, 1.0, 0.2);
  }

  vtkNew<vtkShrinkWrap> Filter;
  EventLog Log;
};

//------------------------------------------------------------------------------
TEST(DamagedFaces, AreLeftOutOfAWrapAndCounted)
{
  const int notFinite = FacesWithPoint7();
  ASSERT_GE(notFinite, 5);
  Wrap(Damaged()).ExpectLeftOut(std::to_string(notFinite + 1) + " of the input's 321 faces were " +
    "left out, the first of them cell ");
}

//------------------------------------------------------------------------------
TEST(DamagedFaces, AStripOfTwoPointsIsOne)
{
  const Surface surface = WithVertex();
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 3, 4 });
  surface->SetStrips(strips);
  Wrap(surface).ExpectLeftOut(
    "1 of the input's 321 faces were left out, the first of them cell 321: 0 with");
}

//------------------------------------------------------------------------------
TEST(DamagedFaces, PointsThatAreNotFiniteAreLeftOutOfAPointSet)
{
  const Surface points = Sample::PointsOf(Sample::Icosphere(3));
  points->GetPoints()->SetPoint(7, 0.0, vtkMath::Nan(), 0.0);
  Wrap(points).ExpectLeftOut(
    "1 of the input's 642 points were left out, the first of them point 7");
}

//------------------------------------------------------------------------------
TEST(DamagedFaces, TheRestIsWrappedAsIfItWereAlone)
{
  const Surface surface = Sample::Icosphere(2);
  const Wrap whole(surface);
  ASSERT_TRUE(whole.Log.Warnings.empty()) << whole.Log.Warnings.front();
  surface->GetPolys()->InsertNextCell({ 0, 1 });
  const Wrap damaged(surface);
  EXPECT_TRUE(SameBits(damaged.Filter->GetOutput()->GetPoints()->GetData(),
    whole.Filter->GetOutput()->GetPoints()->GetData()));
}

//------------------------------------------------------------------------------
TEST(DamagedFaces, AWrapOfNothingElseIsRefused)
{
  const double inf = vtkMath::Inf();
  const Surface faces =
    Sample::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { inf, 1, 0 } }, { { 0, 1, 2 }, { 0, 1 }, {} });
  const Surface points = Sample::Make({ { inf, 0, 0 }, { vtkMath::Nan(), 0, 0 } }, {});
  for (const Surface& surface : { faces, points })
  {
    const Wrap wrap(surface);
    ASSERT_EQ(wrap.Log.Errors.size(), 1u);
    EXPECT_TRUE(IsOneSentence(wrap.Log.Errors.front()));
    EXPECT_TRUE(IsInitialized(wrap.Filter->GetOutput()));
  }
}

//------------------------------------------------------------------------------
/// The sentence in which a filter refuses this input.
template <typename Filter>
std::string RefusalBy(vtkPolyData* input)
{
  vtkNew<Filter> filter;
  EventLog log(filter);
  filter->SetInputData(input);
  filter->Update();
  EXPECT_EQ(log.Errors.size(), 1u);
  EXPECT_TRUE(IsInitialized(filter->GetOutputDataObject(0)));
  return log.Errors.empty() ? std::string() : log.Errors.front();
}

//------------------------------------------------------------------------------
TEST(DamagedFaces, OtherFiltersNameTheFirst)
{
  const Surface twoCorners = WithVertex();
  twoCorners->GetPolys()->InsertNextCell({ 0, 1 });
  // Cell 0 is the vertex, cells 1 to 320 are the sphere.
  for (const std::string& sentence :
    { RefusalBy<vtkMeshSDF>(twoCorners), RefusalBy<vtkSurfaceEvolution>(twoCorners),
      RefusalBy<vtkTangentialRedistribution>(twoCorners) })
  {
    EXPECT_TRUE(IsOneSentence(sentence));
    EXPECT_EQ(sentence.rfind("Cell 321 ", 0), 0u) << sentence;
  }
  const Surface points = Sample::PointsOf(Sample::Icosphere(2));
  points->GetPoints()->SetPoint(5, vtkMath::Nan(), 0.0, 0.0);
  EXPECT_NE(RefusalBy<vtkMeshSDF>(points).find("point 5 "), std::string::npos);
}

} // namespace
