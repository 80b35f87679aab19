// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/UsablePart.h"

#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

#include <limits>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

/// Faces 0 and 3 around a point that is not finite, face 1 of two corners, face 2 good.
SurfaceMesh damagedMesh()
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0),
    Vec3(std::numeric_limits<double>::quiet_NaN(), 0, 0), Vec3(0, 0, 1) };
  mesh.addFace({ 0, 1, 3 });
  mesh.addFace({ 0, 1 });
  mesh.addFace({ 0, 1, 2, 4 });
  mesh.addFace({ 3, 1, 2 });
  return mesh;
}

TEST(UsablePart, AWholeMeshStaysAsItIs)
{
  const SurfaceMesh cube = unitCube();
  EXPECT_EQ(findDamagedParts(cube).count(), 0);
  EXPECT_EQ(findDamagedParts(cube).first, NoIndex);
  EXPECT_TRUE(withoutDamagedParts(cube) == cube);
}

TEST(UsablePart, DamagedFacesAreCountedAndLeftOut)
{
  const DamagedParts damaged = findDamagedParts(damagedMesh());
  EXPECT_EQ(damaged.notFinite, 2);
  EXPECT_EQ(damaged.tooFewCorners, 1);
  EXPECT_EQ(damaged.first, 0);
  std::vector<Index> oldFace;
  const SurfaceMesh usable = withoutDamagedParts(damagedMesh(), &oldFace);
  ASSERT_EQ(usable.faceCount(), 1);
  ASSERT_EQ(oldFace.size(), 1u);
  EXPECT_EQ(damagedMesh().faceSize(oldFace[0]), 4);
  EXPECT_EQ(usable.faceSize(0), 4);
  EXPECT_EQ(usable.faceVertex(0, 3), 4);
  EXPECT_NO_THROW(validate(usable));
  EXPECT_EQ(describeLeftOut(damaged, damagedMesh(), "cell 7"),
    "3 of the input's 4 faces were left out, the first of them cell 7: 2 with coordinates that are "
    "not finite and 1 with fewer than three corners; repair them if they should count.");
}

TEST(UsablePart, PointsThatAreNotFiniteAreLeftOutOfAPointSet)
{
  SurfaceMesh set;
  set.points = { Vec3(1, 2, 3), Vec3(0, std::numeric_limits<double>::infinity(), 0),
    Vec3(4, 5, 6) };
  const DamagedParts damaged = findDamagedParts(set);
  EXPECT_EQ(damaged.count(), 1);
  EXPECT_EQ(damaged.first, 1);
  std::vector<Index> oldPoint;
  const SurfaceMesh usable = withoutDamagedParts(set, &oldPoint);
  ASSERT_EQ(usable.vertexCount(), 2);
  EXPECT_EQ(usable.points[1], Vec3(4, 5, 6));
  EXPECT_EQ(oldPoint, std::vector<Index>({ 0, 2 }));
  EXPECT_EQ(describeLeftOut(damaged, set, "point 1"),
    "1 of the input's 3 points were left out, the first of them point 1: 1 with coordinates that "
    "are not finite; repair them if they should count.");
}

} // namespace

} // namespace evolving
