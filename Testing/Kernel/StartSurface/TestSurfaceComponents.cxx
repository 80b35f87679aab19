// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/SurfaceComponents.h"

#include "Mesh/MeshTopology.h"
#include "Shapes/MeshVariants.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace evolving;

namespace
{

/// A box of side 0.2, a box of side 2 with a cavity of side 1, an unused point.
SurfaceMesh speckAndHollowBox()
{
  SurfaceMesh mesh = subdividedBox(1, Vec3::Constant(0.1), Vec3(5.0, 0.0, 0.0));
  mesh.addPoint(Vec3::Constant(99.0));
  mesh = shapes::merged(mesh, subdividedBox(2, Vec3::Ones()));
  return shapes::merged(mesh, reversed(subdividedBox(1)));
}

} // namespace

TEST(SurfaceComponents, AreMeasured)
{
  const std::vector<SurfaceComponent> parts = surfaceComponents(speckAndHollowBox());
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_NEAR(parts[0].volume, 0.008, 1e-14);
  EXPECT_NEAR(parts[0].area, 0.24, 1e-14);
  EXPECT_NEAR(parts[0].box.center().x(), 5.0, 1e-14);
  EXPECT_NEAR(parts[1].volume, 8.0, 1e-13);
  EXPECT_EQ(parts[1].faces, 24);
  EXPECT_NEAR(parts[2].volume, -1.0, 1e-14);
}

TEST(SurfaceComponents, AreKeptOrDroppedWhole)
{
  const SurfaceMesh mesh = speckAndHollowBox();

  const SurfaceMesh largest = keepLargestComponent(mesh);
  EXPECT_EQ(largest.faceCount(), 24);
  EXPECT_EQ(largest.vertexCount(), 26);
  EXPECT_NEAR(signedVolume(largest), 8.0, 1e-13);

  const SurfaceMesh withoutSpeck = dropSmallComponents(mesh, 0.5);
  EXPECT_EQ(summarizeTopology(withoutSpeck).components, 2);
  EXPECT_NEAR(signedVolume(withoutSpeck), 7.0, 1e-13);

  const SurfaceMesh solid = dropCavityWalls(mesh);
  EXPECT_EQ(solid.faceCount(), 30);
  EXPECT_NEAR(signedVolume(solid), 8.008, 1e-12);
}

TEST(SurfaceComponents, NoneOfNothing)
{
  EXPECT_TRUE(surfaceComponents(SurfaceMesh()).empty());
  EXPECT_EQ(keepLargestComponent(SurfaceMesh()).vertexCount(), 0);
  EXPECT_EQ(dropSmallComponents(subdividedBox(1), 1e9).vertexCount(), 0);
}
