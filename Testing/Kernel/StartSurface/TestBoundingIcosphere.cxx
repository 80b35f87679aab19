// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/BoundingIcosphere.h"

#include "Errors.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

TEST(BoundingIcosphere, InradiusOfTheIcosahedronIsKnown)
{
  // Inradius and circumradius of the icosahedron of edge 1.
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  const double inradius = golden * golden / (2.0 * std::sqrt(3.0));
  const double circumradius = 0.5 * std::sqrt(golden * std::sqrt(5.0));
  EXPECT_NEAR(icosphereInradius(0), inradius / circumradius, 1e-14);
}

TEST(BoundingIcosphere, InradiusGrowsTowardsOneInSecondOrder)
{
  const double coarse = 1.0 - icosphereInradius(3);
  const double fine = 1.0 - icosphereInradius(4);
  EXPECT_GT(fine, 0.0);
  EXPECT_NEAR(coarse / fine, 4.0, 0.1);
}

TEST(BoundingIcosphere, EveryFaceStaysOutsideTheBoxAndTheMargin)
{
  const Box box(Vec3(-1.0, 10.0, 2.0), Vec3(3.0, 10.5, 5.0));
  const double margin = 0.25;
  for (int level = 0; level < 4; ++level)
  {
    const SurfaceMesh sphere = boundingIcosphere(box, level, margin);
    double nearest = 1e300;
    for (Index face = 0; face < sphere.faceCount(); ++face)
    {
      const Vec3 normal = faceVectorArea(sphere, face).normalized();
      nearest = std::min(nearest, normal.dot(sphere.facePoint(face, 0) - box.center()));
    }
    EXPECT_NEAR(nearest, (1.0 + margin) * 0.5 * box.diagonal().norm(), 1e-12);
  }
}

TEST(BoundingIcosphere, RefusesBoxesWithoutExtentAndNegativeMargins)
{
  const Box point(Vec3::Ones(), Vec3::Ones());
  const Box box(Vec3::Zero(), Vec3::Ones());
  EXPECT_THROW(boundingIcosphere(Box(), 2, 0.1), InputError);
  EXPECT_THROW(boundingIcosphere(point, 2, 0.1), InputError);
  EXPECT_THROW(boundingIcosphere(box, 2, -0.1), InputError);
  EXPECT_THROW(boundingIcosphere(box, -1, 0.1), InputError);
}
