// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/NeckSurgery.h"

#include "Mesh/MeshQuality.h"
#include "Mesh/TopologySummary.h"
#include "Remeshing/EditingChecks.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;
using editing::Kind;
using editing::kindOf;

namespace
{

/// A tube of three vertices around, so thin between two bulbs that its edges there are short.
SurfaceMesh dumbbell(double neck)
{
  return shapes::torus(24, 3, 1.0, neck);
}

} // namespace

TEST(NeckSurgery, LeavesASurfaceWithoutNecksAlone)
{
  for (const SurfaceMesh& surface :
    { icosphere(0), icosphere(3), shapes::bumpySphere(3), shapes::torus(24, 12, 1.0, 0.3) })
  {
    EXPECT_TRUE(withNecksCut(surface, meanEdgeLength(surface)) == surface);
  }
}

TEST(NeckSurgery, OpensARing)
{
  // One place is pinched.
  SurfaceMesh ring = shapes::torus(24, 3, 1.0, 0.3);
  for (Vec3& p : ring.points)
  {
    const Vec3 core = Vec3(p.x(), p.y(), 0.0).normalized();
    const double width = core.x() > 0.99 ? 0.02 : 1.0;
    p = core + width * (p - core);
  }
  ASSERT_EQ(kindOf(ring), (Kind{ 0, 0, 1 }));
  const SurfaceMesh opened = withNecksCut(ring, 0.4);
  EXPECT_EQ(kindOf(opened), (Kind{ 2, 0, 1 }));
  EXPECT_NEAR(signedVolume(opened), signedVolume(ring), 1e-9);
  EXPECT_NEAR(surfaceArea(opened), surfaceArea(ring), 1e-3);
}

TEST(NeckSurgery, DropsAThreadButNotAllThatThereIs)
{
  const SurfaceMesh thread = dumbbell(0.01);
  const SurfaceMesh opened = withNecksCut(thread, 1.0);
  EXPECT_TRUE(summarizeTopology(opened).isClosed());
  EXPECT_GT(opened.faceCount(), 0);
}
