// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/CoarseParts.h"

#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace evolving;

SurfaceMesh tetrahedron()
{
  SurfaceMesh mesh;
  mesh.points = { Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ() };
  mesh.addFace({ 0, 2, 1 });
  mesh.addFace({ 0, 1, 3 });
  mesh.addFace({ 1, 2, 3 });
  mesh.addFace({ 2, 0, 3 });
  return mesh;
}

TEST(CoarseParts, AreNoneOfAnIcosahedron)
{
  const CoarseParts parts = findCoarseParts(icosphere(0));
  EXPECT_EQ(parts.areaPart, 0.0);
  EXPECT_EQ(parts.extent, 0.0);
  EXPECT_EQ(parts.flat, 0);
  EXPECT_EQ(findCoarseParts({}).areaPart, 0.0);
}

TEST(CoarseParts, AreThoseOfFewTriangles)
{
  const CoarseParts parts = findCoarseParts(tetrahedron());
  EXPECT_EQ(parts.areaPart, 1.0);
  EXPECT_NEAR(parts.extent, std::sqrt(3.0), 1e-15);
  const Vec3 place(10.0, 0.0, 0.0);
  const SurfaceMesh ball = icosphere(3);
  const SurfaceMesh small = shapes::transformed(tetrahedron(), 0.5, place);
  const CoarseParts ofBoth = findCoarseParts(shapes::merged(ball, small));
  EXPECT_NEAR(
    ofBoth.areaPart, surfaceArea(small) / (surfaceArea(small) + surfaceArea(ball)), 1e-15);
  EXPECT_NEAR(ofBoth.extent, 0.5 * std::sqrt(3.0), 1e-15);
  EXPECT_LT((ofBoth.place - place).norm(), 0.5);
  EXPECT_EQ(ofBoth.flat, 0);
}

TEST(CoarseParts, AreFlatWithoutAVolumeAndInsideOut)
{
  for (const double far : { 0.0, 1e6 })
  {
    SurfaceMesh folded = shapes::transformed(tetrahedron(), 1.0, Vec3::Constant(far));
    folded.points[3].z() = far;
    EXPECT_EQ(findCoarseParts(folded).flat, 1) << far;
  }
  EXPECT_EQ(findCoarseParts(reversed(tetrahedron())).flat, 1);
  SurfaceMesh thin = tetrahedron();
  thin.points[3].z() = 1e-6;
  EXPECT_EQ(findCoarseParts(thin).flat, 0) << "thin, but a body";
}

} // namespace
