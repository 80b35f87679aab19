// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CurveProximity.h"

#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

constexpr double Thickness = 0.1;

/// A plate, and the edge of it that a point lies on.
class PlateProximity : public testing::Test
{
protected:
  Index edgeAt(const Vec3& point) const
  {
    for (const Index edge : this->Sharp.list())
    {
      const auto [a, b] = this->Target.edgeVertices(edge);
      const Vec3 along = this->Target.point(b) - this->Target.point(a);
      const Vec3 from = point - this->Target.point(a);
      if (along.cross(from).norm() < 1e-12 && from.dot(along) > 0.0 &&
        from.dot(along) < along.squaredNorm())
      {
        return edge;
      }
    }
    return NoIndex;
  }

  TargetTriangles Target{ box(Vec3::Zero(), Vec3(1.0, 1.0, Thickness)) };
  SharpEdges Sharp{ this->Target, 45.0, false };
  CurveProximity Proximity{ this->Target, this->Sharp };
};

} // namespace

TEST_F(PlateProximity, IsAcrossTheRim)
{
  const Vec3 middle(0.5, 0.0, 0.0);
  const Index edge = this->edgeAt(middle);
  ASSERT_NE(edge, NoIndex);
  EXPECT_NEAR(this->Proximity.distanceToOther(edge, middle, 0.4), Thickness, 1e-12);
  EXPECT_TRUE(std::isinf(this->Proximity.distanceToOther(edge, middle, 0.9 * Thickness)));
  EXPECT_TRUE(this->Proximity.hasOtherNear(edge, middle, 1.1 * Thickness));
  EXPECT_FALSE(this->Proximity.hasOtherNear(edge, middle, 0.9 * Thickness));
}

TEST_F(PlateProximity, DoesNotCountBesideASharedCorner)
{
  // Near the end of an edge that is nearer to the one it meets there than to the one across.
  const Vec3 end(0.04, 0.0, 0.0);
  const Index edge = this->edgeAt(end);
  ASSERT_NE(edge, NoIndex);
  EXPECT_NEAR(this->Proximity.distanceToOther(edge, end, 0.4), Thickness, 1e-12);
}

TEST_F(PlateProximity, DoesNotCountWhatIsLeftOut)
{
  const Vec3 middle(0.5, 0.0, 0.0);
  const Index edge = this->edgeAt(middle);
  this->Sharp.leaveOut(this->edgeAt(Vec3(0.5, 0.0, Thickness)));
  EXPECT_TRUE(std::isinf(this->Proximity.distanceToOther(edge, middle, 0.4)));
  EXPECT_FALSE(this->Proximity.hasOtherNear(edge, middle, 1.1 * Thickness));
}

namespace
{

/// By the words of CurveProximity, over all creases.
class AllCreases
{
public:
  AllCreases(const TargetTriangles& target, const SharpEdges& sharp)
    : Target(target)
    , Sharp(sharp)
    , Network(target, sharp)
    , Patches(surfacePatches(target, sharp))
  {
  }

  double distanceToOther(Index edge, const Vec3& point, double reach) const
  {
    double nearest = HUGE_VAL;
    for (const Index other : this->Sharp.list())
    {
      const auto [a, b] = this->Target.edgeVertices(other);
      const Triangle segment{ { this->Target.point(a), this->Target.point(b),
        this->Target.point(b) } };
      const double distance = std::sqrt(closestPointOnTriangle(point, segment).squaredDistance);
      if (distance < reach && distance > 0.0 && this->counts(edge, other, point, distance))
      {
        nearest = std::min(nearest, distance);
      }
    }
    return nearest;
  }

  bool hasOtherNear(Index edge, const Vec3& point, double distance) const
  {
    for (const Index other : this->Sharp.list())
    {
      const auto [a, b] = this->Target.edgeVertices(other);
      const Triangle segment{ { this->Target.point(a), this->Target.point(b),
        this->Target.point(b) } };
      if (closestPointOnTriangle(point, segment).squaredDistance < distance * distance &&
        this->counts(edge, other, point, distance))
      {
        return true;
      }
    }
    return false;
  }

private:
  bool counts(Index edge, Index other, const Vec3& point, double distance) const
  {
    const FeatureCurve& curve = this->Network.curves()[at(this->Network.curveOf(edge))];
    const FeatureCurve& otherCurve = this->Network.curves()[at(this->Network.curveOf(other))];
    bool isBesideCorner = false;
    for (const Index end : { curve.vertices.front(), curve.vertices.back() })
    {
      const bool isShared = otherCurve.vertices.front() == end || otherCurve.vertices.back() == end;
      isBesideCorner =
        isBesideCorner || (isShared && (point - this->Target.point(end)).norm() < 2.67 * distance);
    }
    bool isAtSamePatch = false;
    const TriangleEdges& edges = this->Target.edges();
    for (const Index* a = edges.begin(edge); a != edges.end(edge); ++a)
    {
      for (const Index* b = edges.begin(other); b != edges.end(other); ++b)
      {
        isAtSamePatch = isAtSamePatch ||
          this->Patches[TargetTriangles::faceOf(*a)] == this->Patches[TargetTriangles::faceOf(*b)];
      }
    }
    return &curve != &otherCurve && !isBesideCorner && isAtSamePatch;
  }

  const TargetTriangles& Target;
  const SharpEdges& Sharp;
  FeatureCurves Network;
  TriangleLabels Patches;
};

} // namespace

TEST(CurveProximity, IsThatOfAllCreases)
{
  SurfaceMesh bars = box(Vec3::Zero(), Vec3(1.0, 0.2, 0.1));
  bars = merged(bars, box(Vec3(0.0, 0.3, 0.0), Vec3(0.9, 0.33, 0.5)));
  const TargetTriangles target(bars);
  const SharpEdges sharp(target, 45.0, false);
  const CurveProximity proximity(target, sharp);
  const AllCreases all(target, sharp);
  int counts[2] = {};
  for (const Index edge : sharp.list())
  {
    const auto [a, b] = target.edgeVertices(edge);
    for (double t = 0.05; t < 1.0; t += 0.1)
    {
      const Vec3 point = (1.0 - t) * target.point(a) + t * target.point(b);
      for (const double reach : { 0.02, 0.07, 0.15, 0.6, 5.0 })
      {
        const double expected = all.distanceToOther(edge, point, reach);
        const double found = proximity.distanceToOther(edge, point, reach);
        ++counts[std::isinf(expected) ? 1 : 0];
        ASSERT_TRUE(expected == found || std::abs(expected - found) < 1e-12)
          << expected << " " << found << " at " << point.transpose();
        ASSERT_EQ(proximity.hasOtherNear(edge, point, reach), all.hasOtherNear(edge, point, reach));
      }
    }
  }
  EXPECT_GT(counts[0], 100);
  EXPECT_GT(counts[1], 100);
}
