// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What SurfaceRemesher makes of a surface that stands still.

#include "Evolution/SurfaceRemesher.h"

#include "ChangedMembers.h"
#include "Errors.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/CoveringTriangles.h"
#include "Remeshing/EditingChecks.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace evolving;

namespace
{

constexpr SurfaceRemeshingOptions Uniform{ ElementSizing::Uniform };
constexpr SurfaceRemeshingOptions Adaptive{ ElementSizing::CurvatureAdaptive };

SurfaceRemeshingOptions withEdges(SurfaceRemeshingOptions options, double length)
{
  options.edgeLength = length;
  return options;
}

/// As at the end of a flow.
SurfaceMesh remeshed(
  const SurfaceMesh& mesh, const SurfaceRemeshingOptions& options, const Execution& host = {})
{
  SurfaceRemesher remesher(mesh, options);
  return *remesher.remesh({ mesh, mesh.points, {}, true }, host);
}

/// The mean length of edges between two vertices for which a condition holds.
template <class Condition>
double meanLengthWhere(const SurfaceMesh& mesh, const Condition& holds)
{
  double sum = 0.0;
  int count = 0;
  for (Index f = 0; f < mesh.faceCount(); ++f)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Vec3& p = mesh.facePoint(f, k);
      const Vec3& q = mesh.facePoint(f, (k + 1) % 3);
      if (holds(p) && holds(q))
      {
        sum += (p - q).norm();
        ++count;
      }
    }
  }
  return sum / count;
}

} // namespace

TEST(SurfaceRemesher, ReachesTheEdgeLength)
{
  for (const double length : { 0.06, 0.1, 0.2 })
  {
    const SurfaceMesh sphere = remeshed(icosphere(3), withEdges(Uniform, length));
    EXPECT_NEAR(meanEdgeLength(sphere), length, 0.1 * length);
    const SurfaceMesh torus = remeshed(shapes::torus(60, 24, 2.0, 0.7), withEdges(Uniform, length));
    EXPECT_NEAR(meanEdgeLength(torus), length, 0.1 * length);
    EXPECT_EQ(editing::kindOf(torus), (editing::Kind{ 0, 0, 1 }));
  }
  const SurfaceMesh start = shapes::unevenSphere(3);
  EXPECT_EQ(SurfaceRemesher(start, Uniform).edgeLength(start), meanEdgeLength(start));
  EXPECT_NEAR(
    meanEdgeLength(remeshed(start, Uniform)), meanEdgeLength(start), 0.1 * meanEdgeLength(start));
}

TEST(SurfaceRemesher, SizesSuitTheTargetWhereItIsKnown)
{
  SurfaceRemeshingOptions options = Uniform;
  options.targetArea = 0.3;
  const double wanted = coveringEdgeLength(0.3, 2562.0);
  for (const double radius :
    { 0.1, 0.3 }) // smaller than the target, and nearly four times as large
  {
    const SurfaceMesh sphere = icosphere(2, radius);
    EXPECT_NEAR(SurfaceRemesher(sphere, options).edgeLength(sphere), wanted, 1e-12);
  }
  const SurfaceMesh finer = icosphere(5, 0.3);
  EXPECT_NEAR(
    SurfaceRemesher(finer, options).edgeLength(finer), coveringEdgeLength(0.3, 10242.0), 1e-12);
  // A much larger one would have millions of them.
  const SurfaceMesh huge = icosphere(4, 100.0);
  const SurfaceRemesher remesher(huge, options);
  EXPECT_NEAR(coveringVertexCount(surfaceArea(huge), remesher.edgeLength(huge)), 4.0 * 2562.0, 1.0);
  EXPECT_NEAR(remesher.edgeLength(icosphere(2, 0.2)), wanted, 1e-12);
  EXPECT_EQ(SurfaceRemesher(huge, withEdges(options, 7.0)).edgeLength(huge), 7.0);
}

TEST(SurfaceRemesher, ACoarseStartGetsElementsWhereThereIsAField)
{
  SurfaceRemeshingOptions options;
  options.onlyDegenerate = true;
  const SurfaceMesh box = subdividedBox(1);
  ASSERT_GT(smallestAngle(box), 40.0);
  SurfaceRemesher remesher(box, options);
  EXPECT_FALSE(remesher.remesh({ box, box.points, {}, false }, {}));
  const std::vector<double> distance(box.points.size(), 1.0);
  const auto made = remesher.remesh({ box, box.points, distance, false }, {});
  ASSERT_TRUE(made);
  EXPECT_GT(made->vertexCount(), 2000);
  const SurfaceMesh usual = icosphere(3);
  const std::vector<double> distances(usual.points.size(), 1.0);
  EXPECT_FALSE(
    SurfaceRemesher(usual, options).remesh({ usual, usual.points, distances, false }, {}));
}

TEST(SurfaceRemesher, NewElementsAreNoFartherFromTheTarget)
{
  const SurfaceMesh start = icosphere(3);
  const DistanceGrid grid = shapes::cubicGrid(81, 1.2);
  const ScalarImage target(
    grid, shapes::sampled(grid, [](const Vec3& p) { return p.norm() - 0.95; }));
  const std::vector<double> distance(start.points.size(), 0.02); // as if it were nearer than 0.05
  SurfaceRemesher remesher(start, withEdges(Uniform, 0.08));     // all are to be split
  for (const bool isLast : { true, false })
  {
    const auto made = remesher.remesh({ start, start.points, distance, isLast, &target }, {});
    ASSERT_TRUE(made);
    for (const Vec3& p : made->points)
    {
      EXPECT_NEAR(p.norm(), isLast ? 0.97 : 1.0, 0.005);
    }
    EXPECT_GT(smallestAngle(*made), isLast ? 35.0 : 20.0);
  }
}

TEST(SurfaceRemesher, StretchedElementsBecomeGood)
{
  const SurfaceMesh start = shapes::ellipsoid(4, Vec3(0.3, 1.0, 3.0));
  EXPECT_LT(smallestAngle(start), 6.0);
  for (const auto& options : { Uniform, Adaptive })
  {
    const SurfaceMesh mesh = remeshed(start, options);
    EXPECT_GT(smallestAngle(mesh), 35.0);
    EXPECT_GT(summarizeAngles(mesh).mean, 49.0);
    EXPECT_TRUE(selfIntersections(mesh).empty());
    EXPECT_EQ(editing::kindOf(mesh), (editing::Kind{ 2, 0, 1 }));
  }
}

TEST(SurfaceRemesher, AdaptiveElementsAreSmallerWhereTheSurfaceIsCurved)
{
  const SurfaceMesh start = shapes::ellipsoid(5, Vec3(1.0, 1.0, 4.0));
  const SurfaceMesh uniform = remeshed(start, withEdges(Uniform, 0.15));
  const SurfaceMesh adaptive = remeshed(start, withEdges(Adaptive, 0.15));
  EXPECT_NEAR(adaptive.vertexCount(), uniform.vertexCount(), 0.15 * uniform.vertexCount());
  const auto isAtTip = [](const Vec3& p) { return std::abs(p.z()) > 3.6; };
  const auto isAtWaist = [](const Vec3& p) { return std::abs(p.z()) < 1.0; };
  EXPECT_LT(meanLengthWhere(adaptive, isAtTip), 0.6 * meanLengthWhere(adaptive, isAtWaist));
  EXPECT_GT(meanLengthWhere(uniform, isAtTip), 0.9 * meanLengthWhere(uniform, isAtWaist));
}

TEST(SurfaceRemesher, AsManyElementsOnAFlatSurface)
{
  const SurfaceMesh start = shapes::shakenSheet(12, true, 0.3, 1);
  const Index uniform = remeshed(start, withEdges(Uniform, 0.06)).vertexCount();
  const Index adaptive = remeshed(start, withEdges(Adaptive, 0.06)).vertexCount();
  EXPECT_NEAR(adaptive, uniform, 0.05 * uniform);
}

TEST(SurfaceRemesher, ABoundaryKeepsItsVerticesAndShape)
{
  const SurfaceMesh start = shapes::halfSphere(10);
  for (const auto& options : { withEdges(Uniform, 0.05), withEdges(Uniform, 0.4), Adaptive })
  {
    const SurfaceMesh mesh = remeshed(start, options);
    EXPECT_EQ(editing::kindOf(mesh), (editing::Kind{ 1, 1, 1 }));
    const MeshTopology topology(start);
    for (Index i = 0; i < start.vertexCount(); ++i)
    {
      const Vec3& p = start.points[static_cast<std::size_t>(i)];
      EXPECT_EQ(
        std::count(mesh.points.begin(), mesh.points.end(), p) >= 1 || !topology.isBoundary(i),
        true);
    }
  }
  // In a straight line vertices may vanish, corners may not.
  const SurfaceMesh sheet = shapes::sheet(20, true);
  const SurfaceMesh coarse = remeshed(sheet, withEdges(Uniform, 0.1));
  EXPECT_LT(coarse.vertexCount(), 0.5 * sheet.vertexCount());
  EXPECT_NEAR(surfaceArea(coarse), 1.0, 1e-9);
}

TEST(SurfaceRemesher, ASmallComponentKeepsVertices)
{
  const SurfaceMesh start =
    shapes::merged(icosphere(3), shapes::transformed(icosphere(3), 0.1, Vec3(3.0, 0.0, 0.0)));
  const SurfaceMesh mesh = remeshed(start, withEdges(Uniform, 0.2));
  EXPECT_EQ(editing::kindOf(mesh), (editing::Kind{ 4, 0, 2 }));
  const auto small = std::count_if(
    mesh.points.begin(), mesh.points.end(), [](const Vec3& p) { return p.x() > 2.0; });
  EXPECT_GT(small, 50); // edges of 0.2 alone would leave four
  EXPECT_LT(small, 300);
  EXPECT_EQ(
    editing::kindOf(remeshed(shapes::regularTetrahedron(), Uniform)), (editing::Kind{ 2, 0, 1 }));
  EXPECT_GT(smallestAngle(remeshed(shapes::regularTetrahedron(), Uniform)), 20.0);
}

TEST(SurfaceRemesher, WhatHasShrunkToAPointIsLeftOut)
{
  const SurfaceMesh start =
    shapes::merged(icosphere(3), shapes::transformed(icosphere(2), 0.5, Vec3(3.0, 0.0, 0.0)));
  SurfaceMesh shrunk = start;
  for (Vec3& p : shrunk.points)
  {
    p = p.x() > 2.0 ? Vec3(Vec3(3.0, 0.0, 0.0) + 1e-6 * (p - Vec3(3.0, 0.0, 0.0))) : p;
  }
  SurfaceRemesher remesher(start, Uniform);
  const auto mesh = remesher.remesh({ shrunk, start.points, {}, false }, Execution());
  ASSERT_TRUE(mesh);
  EXPECT_EQ(editing::kindOf(*mesh), (editing::Kind{ 2, 0, 1 }));
}

TEST(SurfaceRemesher, MakesNoSelfIntersections)
{
  // Elements so coarse would cut through the sphere inside.
  const SurfaceMesh nested =
    shapes::merged(icosphere(4), reversed(shapes::transformed(icosphere(4), 0.97, Vec3::Zero())));
  const SurfaceMesh crossing =
    shapes::merged(icosphere(3), shapes::transformed(icosphere(3), 1.0, Vec3(1.0, 0.1, 0.2)));
  for (const auto& options : { withEdges(Uniform, 0.4), withEdges(Adaptive, 0.4) })
  {
    const SurfaceMesh mesh = remeshed(nested, options);
    EXPECT_TRUE(selfIntersections(mesh).empty());
    EXPECT_EQ(editing::kindOf(mesh), (editing::Kind{ 4, 0, 2 }));
    // What crosses itself already gets good elements all the same.
    EXPECT_GT(smallestAngle(remeshed(crossing, options)), 35.0);
  }
}

TEST(SurfaceRemesher, GoodElementsStayBetweenSteps)
{
  const SurfaceMesh start = icosphere(3);
  SurfaceRemesher remesher(start, Uniform);
  EXPECT_FALSE(remesher.remesh({ start, start.points, {}, false }, Execution()));
  SurfaceRemesher finer(start, withEdges(Uniform, 0.1));
  EXPECT_TRUE(finer.remesh({ start, start.points, {}, false }, Execution()));
}

TEST(SurfaceRemesher, HasTheSameBitsOnAnyNumberOfThreads)
{
  const SurfaceMesh start = shapes::bumpySphere(4);
  for (const auto& options : { Uniform, Adaptive })
  {
    EXPECT_EQ(remeshed(start, options), remeshed(start, options, threadedExecution(4, 7)));
  }
}

TEST(SurfaceRemesher, ScaleAndRotationDoNotMatter)
{
  const SurfaceMesh start = shapes::unevenSphere(3);
  const SurfaceMesh turned = shapes::mapped(start, shapes::someRotation());
  for (const auto& options : { Uniform, Adaptive })
  {
    const AngleSummary angles = summarizeAngles(remeshed(start, options));
    EXPECT_GT(angles.smallest, 38.0);
    EXPECT_GT(summarizeAngles(remeshed(turned, options)).smallest, 38.0);
    for (const double scale : { 1e-4, 1e4 })
    {
      const SurfaceMesh scaled = shapes::transformed(start, scale, Vec3::Zero());
      const AngleSummary same = summarizeAngles(remeshed(scaled, options));
      EXPECT_GT(same.smallest, 38.0);
      EXPECT_NEAR(same.mean, angles.mean, 0.5);
      EXPECT_NEAR(summarizeAngles(remeshed(turned, options)).mean, angles.mean, 0.5);
    }
  }
}

TEST(SurfaceRemesher, RefusesPolygons)
{
  EXPECT_THROW(SurfaceRemesher(shapes::hexagonalPrism(), Uniform), InputError);
}

TEST(SurfaceRemesher, RefusesAnEdgeLengthThatIsNoNumber)
{
  for (const double length : { std::nan(""), HUGE_VAL, -1.0, 1e-300, 1e300 })
  {
    EXPECT_THROW(SurfaceRemesher(icosphere(1), withEdges(Uniform, length)), InputError);
  }
}

TEST(SurfaceRemesher, OptionsAreEqualOnlyWhenEverythingIs)
{
  expectEveryMemberCounts(SurfaceRemeshingOptions());
}

TEST(SurfaceRemesher, RefusesElementsWithoutNumber)
{
  EXPECT_THROW(remeshed(icosphere(2), withEdges(Uniform, 1e-6)), InputError);
  EXPECT_THROW(remeshed(icosphere(2), withEdges(Adaptive, 1e-6)), InputError);
}

TEST(SurfaceRemesher, MakesItsOwnElementsGoodAtTheEndAndKeepsTheStarts)
{
  SurfaceRemeshingOptions onlyDegenerate;
  onlyDegenerate.onlyDegenerate = true;
  const auto stretched = [](const SurfaceMesh& mesh)
  { return shapes::mapped(mesh, Vec3(1.0, 1.0, 2.0).asDiagonal().toDenseMatrix()); };
  const SurfaceMesh start = stretched(icosphere(4));
  SurfaceRemesher remesher(start, onlyDegenerate);
  const auto atEnd = [&](const SurfaceMesh& mesh) {
    return remesher.remesh({ mesh, mesh.points, {}, true }, {});
  };
  ASSERT_LT(smallestAngle(start), 35.0); // no good ones, but nobody asked for others
  EXPECT_FALSE(atEnd(start).has_value());
  const SurfaceMesh own = remeshed(icosphere(4), withEdges(Uniform, 0.15));
  const SurfaceMesh later = stretched(own);
  ASSERT_LT(smallestAngle(later), 35.0);
  EXPECT_FALSE(remesher.remesh({ later, later.points, {}, false }, {}).has_value());
  onlyDegenerate.keepsStart = false;
  SurfaceRemesher atOnce(start, onlyDegenerate);
  EXPECT_TRUE(atOnce.remesh({ start, start.points, {}, false }, {}).has_value());
  EXPECT_FALSE(atOnce.remesh({ later, later.points, {}, false }, {}).has_value());
  ASSERT_TRUE(atEnd(later).has_value());
  EXPECT_GT(smallestAngle(*atEnd(later)), 38.0);
}
