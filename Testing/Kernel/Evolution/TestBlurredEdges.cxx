// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/BlurredEdges.h"

#include "Mesh/MeshTopology.h"
#include "Operators/SurfaceGeometry.h"
#include "Shapes/MeshVariants.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace evolving;

namespace
{

std::vector<Vec3> shifted(const SurfaceMesh& mesh, double blur)
{
  const MeshTopology topology(mesh);
  SurfaceGeometry geometry(topology);
  geometry.update(mesh, {});
  return onBlurredEdges(mesh, geometry, blur);
}

} // namespace

TEST(BlurredEdges, OfBallsLieInsideByTheBlurOverTheRadius)
{
  for (const double radius : { 3.0, 5.0, 20.0 })
  {
    for (const Vec3& p : shifted(icosphere(3, radius), 1.06))
    {
      EXPECT_NEAR(p.norm(), radius - 1.06 / radius, 0.01 * 1.06 / radius);
    }
  }
}

TEST(BlurredEdges, AreThoseOfEachComponentByItself)
{
  SurfaceMesh both = icosphere(3, 4.0);
  const Index first = both.vertexCount();
  const SurfaceMesh other = shapes::transformed(icosphere(3, 10.0), 1.0, Vec3(30, 0, 0));
  for (const Vec3& p : other.points)
  {
    both.addPoint(p);
  }
  for (Index f = 0; f < other.faceCount(); ++f)
  {
    both.addFace({ first + other.faceVertex(f, 0), first + other.faceVertex(f, 1),
      first + other.faceVertex(f, 2) });
  }
  const std::vector<Vec3> points = shifted(both, 1.0);
  EXPECT_NEAR(points[0].norm(), 4.0 - 0.25, 0.01);
  EXPECT_NEAR((points[at(first)] - Vec3(30, 0, 0)).norm(), 10.0 - 0.1, 0.01);
}

TEST(BlurredEdges, AreWhereTheyAreWithoutBlurAndNotBeyondItsWidth)
{
  const SurfaceMesh ball = icosphere(2, 0.5);
  EXPECT_EQ(shifted(ball, 0.0), ball.points);
  for (const Vec3& p : shifted(ball, 0.04)) // 0.08 inside: less than 0.2
  {
    EXPECT_NEAR(p.norm(), 0.42, 0.01);
  }
  for (const Vec3& p : shifted(ball, 0.36)) // 0.72 inside, but for the width of 0.6
  {
    EXPECT_NEAR((p - p.normalized() * 0.1).norm(), 0.0, 0.01);
  }
}
