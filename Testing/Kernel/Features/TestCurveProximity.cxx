// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CurveProximity.h"

#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

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
