// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/FinishSteps.h"

#include "Mesh/MeshQuality.h"
#include "Remeshing/RemeshingShapes.h"
#include "ShrinkWrap/WrapReference.h"
#include "ShrinkWrap/WrapRuns.h"
#include "ShrinkWrap/WrapView.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using namespace evolving;

class MendedSphere : public testing::Test
{
protected:
  FinishSteps steps() const { return { *this->View.reference(), *this->View.target(), this->Run }; }

  /// Moves a vertex nearly onto a neighbour.
  static void squash(EditableSurface& surface, Index v)
  {
    Index neighbour = NoIndex;
    surface.forEachNeighbour(v, [&](Index u) { neighbour = u; });
    surface.setPoint(v, 0.03 * surface.point(v) + 0.97 * surface.point(neighbour));
  }

  ShrinkWrapOptions Options = wraps::quick();
  Execution Run;
  WrapView View{ icosphere(5), Options, firstResolution(Options), {}, Run };
  EditableSurface Surface = shapes::sized(icosphere(3), 0.15);
};

TEST_F(MendedSphere, HasNoSliversAndIsTheSameElsewhere)
{
  EXPECT_FALSE(this->steps().hasSlivers(this->Surface));
  const Vec3 place = this->Surface.point(100);
  squash(this->Surface, 100);
  const SurfaceMesh before = this->Surface.mesh();
  ASSERT_TRUE(this->steps().hasSlivers(this->Surface));
  this->steps().mend(this->Surface);
  this->Surface.releaseLocks();
  EXPECT_FALSE(this->steps().hasSlivers(this->Surface));
  const SurfaceMesh after = this->Surface.mesh();
  EXPECT_GT(smallestAngle(after), 30.0);
  Index same = 0;
  for (const Vec3& point : before.points)
  {
    const bool isKept =
      std::find(after.points.begin(), after.points.end(), point) != after.points.end();
    EXPECT_TRUE(isKept || (point - place).norm() < 1.0);
    same += isKept ? 1 : 0;
  }
  EXPECT_GT(same, 0.7 * before.vertexCount());
}

} // namespace
