// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/TargetFeatures.h"

#include "Errors.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "ThreadedExecution.h"
#include "Trees/TriangleGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

const FeatureOptions Defaults;

/// Patches, darts and a round face: a ridge that ends inside a cylinder's cap.
SurfaceMesh cappedCylinder()
{
  return extruded(regularPolygon(24), 1.3);
}

double squaredDistanceToEdge(const TargetTriangles& target, Index edge, const Vec3& point)
{
  const auto [a, b] = target.edgeVertices(edge);
  const Triangle segment{ { target.point(a), target.point(b), target.point(b) } };
  return closestPointOnTriangle(point, segment).squaredDistance;
}

/// The smallest value over the numbers below count for which `chosen` is true.
template <typename Chosen, typename Value>
double smallest(Index count, const Chosen& chosen, const Value& value)
{
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < count; ++i)
  {
    least = chosen(i) ? std::min(least, value(i)) : least;
  }
  return least;
}

/// What must not depend on how the same surface is given.
struct Summary
{
  explicit Summary(const TargetFeatures& features)
    : edges(features.sharpEdges().list().size())
    , curves(features.curves().curves().size())
    , corners(features.curves().corners().size())
    , patches(features.patchCount())
    , labels(features.labelCount())
    , length(features.borders().length(EdgeKind::Sharp))
    , artificial(features.borders().length(EdgeKind::Artificial))
  {
  }
  void expectEqual(const Summary& other, double scale = 1.0) const
  {
    EXPECT_EQ(this->edges, other.edges);
    EXPECT_EQ(this->curves, other.curves);
    EXPECT_EQ(this->corners, other.corners);
    EXPECT_EQ(this->patches, other.patches);
    EXPECT_EQ(this->labels, other.labels);
    EXPECT_NEAR(this->length * scale, other.length, 1e-9 * scale);
    EXPECT_NEAR(this->artificial * scale, other.artificial, 1e-9 * scale);
  }
  std::size_t edges;
  std::size_t curves;
  std::size_t corners;
  Index patches;
  Index labels;
  double length;
  double artificial;
};

std::vector<SurfaceMesh> creasedSurfaces()
{
  return { box(Vec3(0, 0, 0), Vec3(1, 2, 3)), cappedCylinder(), fadingRidge(20), pressedWedge(40) };
}

} // namespace

TEST(TargetFeatures, AreThoseOfSoupsAndTurnedFaces)
{
  for (const SurfaceMesh& mesh : creasedSurfaces())
  {
    const Summary expected(findFeatures(mesh, Defaults));
    const SurfaceMesh mixed = turned(mesh, [](Index face) { return face % 5 < 2; });
    Summary(findFeatures(mixed, Defaults)).expectEqual(expected);
    Summary(findFeatures(soupOf(mixed), Defaults)).expectEqual(expected);
  }
}

TEST(TargetFeatures, DoNotDependOnPlaceAndUnit)
{
  std::mt19937 generator(3);
  for (const SurfaceMesh& mesh : creasedSurfaces())
  {
    FeatureOptions options;
    options.edgeLength = 0.05;
    const Summary expected(findFeatures(mesh, options));
    const SurfaceMesh rotated = mapped(mesh, randomRotation(generator));
    Summary(findFeatures(rotated, options)).expectEqual(expected);
    const SurfaceMesh far = transformed(mesh, 1.0, Vec3(300, -200, 100));
    Summary(findFeatures(far, options)).expectEqual(expected);
    for (const double scale : { 1e-4, 1e4 })
    {
      options.edgeLength = 0.05 * scale;
      const SurfaceMesh scaled = transformed(mesh, scale, Vec3::Zero());
      expected.expectEqual(Summary(findFeatures(scaled, options)), scale);
    }
  }
}

TEST(TargetFeatures, DoNotDependOnThreads)
{
  const SurfaceMesh mesh = pressedWedge(60);
  const TargetFeatures serial = findFeatures(mesh, Defaults);
  for (const int threads : { 2, 8 })
  {
    const TargetFeatures parallel = findFeatures(mesh, Defaults, threadedExecution(threads, 5u));
    EXPECT_EQ(parallel.sharpEdges().list(), serial.sharpEdges().list());
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      ASSERT_EQ(parallel.labelOf(face), serial.labelOf(face));
    }
  }
}

TEST(TargetFeatures, FindClosestPointsAsAllTrianglesSay)
{
  std::mt19937 generator(5);
  for (const SurfaceMesh& mesh : creasedSurfaces())
  {
    const TargetFeatures features = findFeatures(mesh, Defaults);
    const SurfaceMesh& target = features.target().mesh();
    for (int k = 0; k < 100; ++k)
    {
      const Vec3 point = 1.5 * randomPoint(generator);
      const auto squaredDistance = [&](Index face)
      { return closestPointOnTriangle(point, triangleOf(target, face)).squaredDistance; };
      const LabelledPoint closest = features.closestPoint(point);
      EXPECT_NEAR(closest.squaredDistance,
        smallest(
          target.faceCount(), [](Index) { return true; }, squaredDistance),
        1e-12);
      EXPECT_EQ(closest.label, features.labelOf(closest.triangle));
      for (Index label = 0; label < features.labelCount(); ++label)
      {
        const LabelledPoint inLabel = features.closestPointWithLabel(point, label);
        EXPECT_EQ(features.labelOf(inLabel.triangle), label);
        EXPECT_NEAR(inLabel.squaredDistance, squaredDistance(inLabel.triangle), 1e-12);
        EXPECT_NEAR(inLabel.squaredDistance,
          smallest(
            target.faceCount(), [&](Index face) { return features.labelOf(face) == label; },
            squaredDistance),
          1e-12);
      }
    }
  }
}

TEST(TargetFeatures, FindNothingBeyondABound)
{
  const TargetFeatures cube = findFeatures(box(Vec3(0, 0, 0), Vec3(1, 1, 1)), Defaults);
  EXPECT_EQ(cube.closestPointWithLabel(Vec3(0.5, 0.5, 3.0), 0, 0.01).triangle, NoIndex);
  const LabelledPoint above = cube.closestPoint(Vec3(0.5, 0.5, 3.0));
  EXPECT_DOUBLE_EQ(above.squaredDistance, 4.0);
}

TEST(TargetFeatures, FindClosestPointsOfCurvesAndCorners)
{
  std::mt19937 generator(6);
  for (const SurfaceMesh& mesh : creasedSurfaces())
  {
    const TargetFeatures features = findFeatures(mesh, Defaults);
    const TargetTriangles& target = features.target();
    for (int k = 0; k < 100; ++k)
    {
      const Vec3 point = 1.5 * randomPoint(generator);
      const EdgePoint onCurve = features.closestOnCurves(point);
      ASSERT_TRUE(onCurve.exists());
      EXPECT_NE(features.curves().curveOf(onCurve.edge), NoIndex);
      EXPECT_NEAR((onCurve.point - point).squaredNorm(), onCurve.squaredDistance, 1e-12);
      EXPECT_NEAR(onCurve.squaredDistance,
        smallest(
          target.edges().edgeCount(),
          [&](Index edge) { return features.sharpEdges().isSharp(edge); },
          [&](Index edge) { return squaredDistanceToEdge(target, edge, point); }),
        1e-12);
      const Index corner = features.closestCorner(point);
      const auto toVertex = [&](Index v) { return (target.point(v) - point).squaredNorm(); };
      const double nearest = smallest(
        target.mesh().vertexCount(), [&](Index v) { return features.curves().isCorner(v); },
        toVertex);
      EXPECT_EQ(corner == NoIndex, std::isinf(nearest));
      EXPECT_TRUE(corner == NoIndex || toVertex(corner) == nearest);
    }
  }
}

TEST(TargetFeatures, TellTheSharpPartOfABorderFromTheArtificialOne)
{
  const TargetFeatures ridge = findFeatures(fadingRidge(20), { 60.0, 0.0, false });
  const LabelBorders& borders = ridge.borders();
  // The ridge is sharp from x = -1 to -0.2 and artificial from there to 1.
  const Vec3 point(0.5, 0.1, 0.3);
  const EdgePoint sharp = borders.closest(point, 0, 1, EdgeKind::Sharp);
  EXPECT_NEAR((sharp.point - Vec3(-0.2, 0, 0)).norm(), 0.0, 1e-12);
  const EdgePoint artificial = borders.closest(point, 1, 0, EdgeKind::Artificial);
  EXPECT_NEAR((artificial.point - Vec3(0.5, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(borders.closest(point, 0, 1).edge, artificial.edge);
  EXPECT_EQ(borders.kind(artificial.edge), EdgeKind::Artificial);
  EXPECT_EQ(borders.kind(borders.closest(Vec3(-0.7, 0, 0), 0, 1).edge), EdgeKind::Sharp);
  EXPECT_FALSE(borders.closest(point, 0, 1, EdgeKind::Inner).exists());
  EXPECT_FALSE(borders.closest(point, 0, 0).exists());
}

TEST(TargetFeatures, KnowWhereLabelsMeet)
{
  const TargetFeatures cube = findFeatures(box(Vec3(0, 0, 0), Vec3(1, 1, 1)), Defaults);
  ASSERT_EQ(cube.borders().meetings().size(), 8u);
  for (const LabelBorders::Meeting& meeting : cube.borders().meetings())
  {
    ASSERT_EQ(meeting.labels.size(), 3u);
    EXPECT_EQ(cube.borders().closestMeeting(Vec3(0.5, 0.5, 0.5), meeting.labels), meeting.vertex);
    const Vec3 corner = cube.target().point(meeting.vertex);
    const EdgePoint onEdge =
      cube.borders().closest(2.0 * corner, meeting.labels[0], meeting.labels[1]);
    EXPECT_NEAR((onEdge.point - corner).norm(), 0.0, 1e-12);
  }
  const Index bottom = cube.closestPoint(Vec3(0.5, 0.5, -1.0)).label;
  const Index top = cube.closestPoint(Vec3(0.5, 0.5, 2.0)).label;
  const Index side = cube.closestPoint(Vec3(2.0, 0.5, 0.5)).label;
  std::vector<Index> labels{ bottom, top, side };
  std::sort(labels.begin(), labels.end());
  EXPECT_EQ(cube.borders().closestMeeting(Vec3(0, 0, 0), labels), NoIndex);
  EXPECT_FALSE(cube.borders().closest(Vec3(0, 0, 0), bottom, top).exists());
}

TEST(TargetFeatures, OfASmoothSurfaceAreNone)
{
  const TargetFeatures round = findFeatures(sphere(4), Defaults);
  EXPECT_EQ(round.labelCount(), 1);
  EXPECT_FALSE(round.closestOnCurves(Vec3(2, 0, 0)).exists());
  EXPECT_EQ(round.closestCorner(Vec3(2, 0, 0)), NoIndex);
  EXPECT_TRUE(round.borders().meetings().empty());
}

TEST(TargetFeatures, KnowTheFaceTheirTrianglesComeFrom)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(0, 0, 1) };
  mesh.addFace({ 0, 0, 1 });
  mesh.addFace({ 0, 1, 2, 3 });
  mesh.addFace({ 0, 1, 4 });
  const TargetFeatures features = findFeatures(mesh, Defaults);
  EXPECT_EQ(features.target().oldFace(), (std::vector<Index>{ 1, 1, 2 }));
  EXPECT_EQ(features.labelCount(), 2);
}

TEST(TargetFeatures, RefuseWhatTheyCannotUse)
{
  const SurfaceMesh cube = box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_THROW(findFeatures(cube, { -1.0, 0.0, false }), InputError);
  EXPECT_THROW(findFeatures(cube, { 181.0, 0.0, false }), InputError);
  EXPECT_THROW(findFeatures(cube, { 45.0, -1.0, false }), InputError);
  EXPECT_THROW(findFeatures(cube, { 45.0, std::nan(""), false }), InputError);
  SurfaceMesh empty;
  EXPECT_THROW(findFeatures(empty, Defaults), InputError);
  SurfaceMesh needle;
  needle.points = { Vec3(0, 0, 0), Vec3(1, 0, 0) };
  needle.addFace({ 0, 1, 1 });
  EXPECT_THROW(findFeatures(needle, Defaults), InputError);
}
