// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What a wrap makes of shapes that engineers bring: a picture of each, and beside it numbers that
// fail where a hole is lost or a rim becomes a saw. The limits are what was measured and a margin.

#include "DataChecks.h"
#include "Picture.h"
#include "RaggedEdges.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Wrapped(vtkPolyData* shape, int numberOfPoints)
{
  vtkNew<vtkShrinkWrap> wrap;
  wrap->SetInputData(shape);
  wrap->SetTargetNumberOfPoints(numberOfPoints);
  wrap->Update();
  return wrap->GetOutput();
}

//------------------------------------------------------------------------------
/// Is the picture of a result, from a direction, the baseline of this name?
bool LooksAs(const std::string& baseline, vtkPolyData* result, const Sample::Point& from)
{
  Picture picture(400, 400);
  picture.AddEdges(result);
  picture.LookFrom(from[0], from[1], from[2]);
  return picture.Matches(baseline);
}

//------------------------------------------------------------------------------
/// Of one closed surface.
int GenusOf(vtkPolyData* result)
{
  return 1 - EulerCharacteristic(result) / 2;
}

//------------------------------------------------------------------------------
void ExpectClean(vtkPolyData* result)
{
  EXPECT_EQ(CountBadEdges(result), 0);
  EXPECT_EQ(FieldValue(result, "SelfIntersections"), 0.0);
}

//------------------------------------------------------------------------------
/// Of one machined part all edges, and the holes.
void ExpectAsMachined(vtkPolyData* result, vtkPolyData* part, int genus, double farthest)
{
  ExpectClean(result);
  EXPECT_EQ(GenusOf(result), genus);
  EXPECT_GT(SmallestAngleOf(result), 35.0);
  EXPECT_LT(LargestDistance(result, part), farthest);
  EXPECT_EQ(RaggedLengthOf(result, part), 0.0);
  EXPECT_NEAR(SharpLengthOf(result), SharpLengthOf(part), 0.01 * SharpLengthOf(part));
}

//------------------------------------------------------------------------------
TEST(Images, WrappedClamp)
{
  const auto clamp = Sample::Read("clamp.obj");
  const auto result = Wrapped(clamp, 3000);
  EXPECT_TRUE(LooksAs("WrappedClamp", result, { 1.0, 1.2, 1.2 }));
  ExpectAsMachined(result, clamp, 2, 0.15);
}

//------------------------------------------------------------------------------
TEST(Images, WrappedPerforatedSheet)
{
  const auto sheet = Sample::Read("perforated_sheet.obj");
  const auto result = Wrapped(sheet, 0);
  EXPECT_TRUE(LooksAs("WrappedPerforatedSheet", result, { 0.3, -0.5, 1.0 }));
  ExpectAsMachined(result, sheet, 12, 0.035);
}

//------------------------------------------------------------------------------
TEST(Images, WrappedRibCooler)
{
  const auto cooler = Sample::Read("rib_cooler.obj");
  const auto result = Wrapped(cooler, 6000);
  EXPECT_TRUE(LooksAs("WrappedRibCooler", result, { 0.4, -0.5, 1.0 }));
  ExpectClean(result);
  EXPECT_EQ(GenusOf(result), 0);
  EXPECT_GT(SmallestAngleOf(result), 30.0);
  EXPECT_LT(LargestDistance(result, cooler), 1e-4);
  EXPECT_EQ(RaggedLengthOf(result, cooler), 0.0);
  // Of the base, 36 x 30 x 5, and what of the six ribs, 2 x 30 x 12, is above it.
  EXPECT_NEAR(VolumeOf(result), 9720.0, 10.0);
}

//------------------------------------------------------------------------------
TEST(Images, WrappedBowl)
{
  const auto bowl = Sample::Read("bowl.ply");
  const auto result = Wrapped(bowl, 3000);
  EXPECT_TRUE(LooksAs("WrappedBowl", result, { 0.0, -1.0, 1.0 }));
  ExpectClean(result);
  EXPECT_EQ(GenusOf(result), 0);
  EXPECT_GT(SmallestAngleOf(result), 35.0);
  EXPECT_LT(LargestDistance(result, bowl), 0.5);
  // A rim of two lines, 57 long each; were it a saw, the length would be 132.
  EXPECT_EQ(RaggedLengthOf(result, bowl), 0.0);
  EXPECT_NEAR(SharpLengthOf(result), 2.0 * 57.0, 4.0);
}

//------------------------------------------------------------------------------
TEST(Images, WrappedBarHeap)
{
  const auto heap = Sample::Read("bar_heap.ply");
  const auto result = Wrapped(heap, 4000);
  EXPECT_TRUE(LooksAs("WrappedBarHeap", result, { 0.2, -0.6, 1.0 }));
  ExpectClean(result);
  // Of eight to ten holes between bars, those narrower than these triangles close.
  EXPECT_GE(GenusOf(result), 5);
  EXPECT_LE(GenusOf(result), 10);
  EXPECT_GT(SmallestAngleOf(result), 25.0);
  EXPECT_LT(LargestDistance(result, heap), 2.0);
  // A quarter of the edges yet, corners where bars cross among them.
  EXPECT_LT(RaggedLengthOf(result, heap), 0.33 * SharpLengthOf(result));
}

//------------------------------------------------------------------------------
TEST(Images, WrappedBracket)
{
  const auto bracket = Sample::Read("bracket.vtk");
  const auto result = Wrapped(bracket, 3000);
  EXPECT_TRUE(LooksAs("WrappedBracket", result, { 0.35, 0.3, 1.0 }));
  ExpectAsMachined(result, bracket, 2, 0.09);
}

} // namespace
