// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What the judges measure with, against shapes whose numbers are known.

#include "BaseShapes.h"
#include "DistanceReference.h"
#include "PolygonEars.h"
#include "Subject.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace
{

using namespace robustness;

Surface surfaceOf(const Model& model)
{
  return robustness::surfaceOf(toPolyData(model));
}

Model make(const std::vector<Vec3>& points, const std::vector<Cell>& polygons)
{
  Model model;
  model.points = points;
  model.polygons = polygons;
  return model;
}

TEST(JudgesTopology, IsThatOfAClosedSurface)
{
  const Topology topology = topologyOf(surfaceOf(icosphere(2, 1.0, Vec3::Zero())));
  EXPECT_TRUE(topology.isClosed() && topology.isManifold() && topology.isOriented());
  EXPECT_EQ(topology.genus(), 0);
  EXPECT_EQ(topology.components, 1);
}

TEST(JudgesTopology, SeesHolesFlipsAndCrowds)
{
  Model model = icosphere(1, 1.0, Vec3::Zero());
  Surface surface = surfaceOf(model);
  std::swap(surface.faces[7][0], surface.faces[7][1]);
  EXPECT_EQ(topologyOf(surface).turnedEdges, 3);
  surface.faces.erase(surface.faces.begin() + 7);
  EXPECT_EQ(topologyOf(surface).borderEdges, 3);
  // Two tetrahedra that share a corner, then an edge.
  const std::vector<Vec3> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 2, 1, 0 },
    { 1, 2, 0 }, { 1, 1, 2 } };
  const auto tetrahedron = [](std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d) {
    return std::vector<Cell>{ { a, c, b }, { a, b, d }, { b, c, d }, { c, a, d } };
  };
  std::vector<Cell> faces = tetrahedron(0, 1, 2, 3);
  const std::vector<Cell> atCorner = tetrahedron(1, 4, 5, 6);
  faces.insert(faces.end(), atCorner.begin(), atCorner.end());
  EXPECT_EQ(topologyOf(surfaceOf(make(points, faces))).crowdedVertices, 1);
  const std::vector<Cell> atEdge = tetrahedron(1, 2, 5, 6);
  faces.resize(4);
  faces.insert(faces.end(), atEdge.begin(), atEdge.end());
  EXPECT_EQ(topologyOf(surfaceOf(make(points, faces))).crowdedEdges, 1);
}

TEST(JudgesTopology, JoinsEqualPoints)
{
  Model model = icosphere(1, 1.0, Vec3::Zero());
  for (Cell& polygon : model.polygons)
  {
    for (std::int64_t& id : polygon)
    {
      id = model.addPoint(Vec3(model.points[static_cast<std::size_t>(id)]));
    }
  }
  EXPECT_FALSE(topologyOf(surfaceOf(model)).isClosed());
  EXPECT_TRUE(topologyOf(welded(surfaceOf(model))).isClosed());
}

TEST(JudgesTopology, KeepsClosedPartsApart)
{
  Model model = icosphere(1, 1.0, Vec3::Zero());
  append(icosphere(1, 1.0, Vec3::Zero()), model);
  EXPECT_EQ(topologyOf(welded(surfaceOf(model))).components, 2);
  // Without a face neither its points nor those of the other one are known to be apart.
  model.polygons.pop_back();
  model.polygons.erase(model.polygons.begin());
  EXPECT_EQ(topologyOf(welded(surfaceOf(model))).components, 1);
}

TEST(JudgesIntersections, AreCountedPairByPair)
{
  const std::vector<Vec3> points{ { -1, -1, 0 }, { 1, -1, 0 }, { 0, 1, 0 }, { 0, 0, -1 },
    { 0, 0, 1 }, { 0, 3, 0 } };
  EXPECT_EQ(intersectionsOf(surfaceOf(make(points, { { 0, 1, 2 }, { 3, 4, 5 } }))), 1);
  EXPECT_EQ(intersectionsOf(surfaceOf(make(points, { { 0, 1, 2 }, { 0, 1, 4 } }))), 0);
  Model twice = icosphere(1, 1.0, Vec3::Zero());
  EXPECT_EQ(intersectionsOf(surfaceOf(twice)), 0);
  append(icosphere(1, 1.0, Vec3(0.5, 0.0, 0.0)), twice);
  EXPECT_GT(intersectionsOf(surfaceOf(twice)), 20);
}

TEST(JudgesMeasures, AreThoseOfABox)
{
  const Surface surface = surfaceOf(box({ 1.0, 2.0, 3.0 }, { 2, 2, 2 }));
  EXPECT_DOUBLE_EQ(areaOf(surface), 88.0);
  EXPECT_NEAR(volumeOf(surface, middleOf(surface)), 48.0, 1e-12);
  EXPECT_DOUBLE_EQ(smallestAngleOf(surface), 90.0);
  EXPECT_NEAR(smallestOuterVolume(surface), 48.0, 1e-12);
}

TEST(JudgesMeasures, TellAPartThatFacesInwardsFromAHollow)
{
  const auto withInsideOut = [](const Vec3& centre)
  {
    Model model = icosphere(1, 1.0, Vec3::Zero());
    Model inner = icosphere(1, 0.3, centre);
    for (Cell& polygon : inner.polygons)
    {
      std::swap(polygon[0], polygon[1]);
    }
    append(inner, model);
    return surfaceOf(model);
  };
  EXPECT_GT(smallestOuterVolume(withInsideOut(Vec3::Zero())), 1.0);
  EXPECT_LT(smallestOuterVolume(withInsideOut(Vec3(3.0, 0.0, 0.0))), 0.0);
}

TEST(JudgesWinding, IsOneInside)
{
  const Model model = icosphere(1, 1.0, Vec3::Zero());
  EXPECT_NEAR(windingNumber(model.points, model.solid, Vec3(0.1, 0.2, 0.3)), 1.0, 1e-12);
  EXPECT_NEAR(windingNumber(model.points, model.solid, Vec3(2.0, 0.0, 0.0)), 0.0, 1e-12);
}

TEST(JudgesDistance, IsToFaceEdgeAndCorner)
{
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_DOUBLE_EQ(distanceToTriangle({ 0.2, 0.2, 3.0 }, a, b, c), 3.0);
  EXPECT_DOUBLE_EQ(distanceToTriangle({ 0.5, -2.0, 0.0 }, a, b, c), 2.0);
  EXPECT_DOUBLE_EQ(distanceToTriangle({ 4.0, 0.0, 4.0 }, a, b, c), 5.0);
  EXPECT_DOUBLE_EQ(distanceToTriangle({ 1.0, 1.0, 0.0 }, a, b, c), std::sqrt(0.5));
}

TEST(JudgesDistance, IsRightWithoutArea)
{
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(3, 0, 0);
  EXPECT_DOUBLE_EQ(distanceToTriangle({ 2.0, 2.0, 0.0 }, a, b, c), 2.0);
  EXPECT_DOUBLE_EQ(distanceToTriangle({ 0.0, 3.0, 4.0 }, a, a, a), 5.0);
}

TEST(JudgesDistance, LiesBetweenBoundsWhereAPolygonIsLoose)
{
  // A quad folded along one of its diagonals: over its middle, the other one is farther.
  const Model folded =
    make({ { 0, 0, 0 }, { 1, 0, 1 }, { 1, 1, 0 }, { 0, 1, 1 } }, { { 0, 1, 2, 3 } });
  const DistanceBounds bounds = DistanceReference(toPolyData(folded))(Vec3(0.5, 0.5, 1.0));
  EXPECT_DOUBLE_EQ(bounds.lower, 0.0);
  EXPECT_GT(bounds.upper, 0.4);
  const Model flat =
    make({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, { { 0, 1, 2, 3 } });
  const DistanceBounds known = DistanceReference(toPolyData(flat))(Vec3(0.5, 0.4, 1.0));
  EXPECT_DOUBLE_EQ(known.lower, 1.0);
  EXPECT_DOUBLE_EQ(known.upper, 1.0);
}

TEST(JudgesEars, CutAConcavePolygon)
{
  const std::vector<Vec3> points{ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 2, 1, 0 }, { 0, 4, 0 } };
  const Cell polygon{ 0, 1, 2, 3, 4 };
  EXPECT_TRUE(isPlanarAndSimple(points, polygon));
  Surface cut;
  cut.points = points;
  for (const Triangle& ear : earsOf(points, polygon))
  {
    cut.faces.emplace_back(ear.begin(), ear.end());
  }
  ASSERT_EQ(cut.faces.size(), 3u);
  EXPECT_DOUBLE_EQ(areaOf(cut), 10.0);
  EXPECT_FALSE(isPlanarAndSimple(points, { 0, 2, 1, 4 }));
}

} // namespace
