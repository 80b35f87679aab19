// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Which targets have a genus that a result should have.

#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Tubes.h"
#include "ShrinkWrap/WantedGenus.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>

using namespace evolving;

namespace
{

SurfaceMesh slab(int holes)
{
  std::mt19937 generator(1);
  return shapes::triangulated(shapes::slabWithHoles(holes), generator);
}

} // namespace

TEST(WrapGenus, IsKnownOfOneCleanClosedSurface)
{
  const ShrinkWrapOptions options;
  EXPECT_EQ(genusToKeep(icosphere(2), options), std::optional<Index>(0));
  EXPECT_EQ(genusToKeep(shapes::torus(24, 12, 1.0, 0.3), options), std::optional<Index>(1));
  EXPECT_EQ(genusToKeep(slab(3), options), std::optional<Index>(3));
}

TEST(WrapGenus, IsNotAskedForOfOthers)
{
  const SurfaceMesh sphere = icosphere(2);
  const ShrinkWrapOptions options;
  EXPECT_FALSE(genusToKeep(shapes::without(sphere, [](Index f) { return f == 0; }), options));
  EXPECT_FALSE(
    genusToKeep(shapes::merged(sphere, shapes::transformed(sphere, 0.5, Vec3::Zero())), options));
  SurfaceMesh crossing = sphere;
  crossing.points[0] = -3.0 * crossing.points[0];
  EXPECT_FALSE(genusToKeep(crossing, options));
  ShrinkWrapOptions closing;
  closing.gapSize = 0.1;
  EXPECT_FALSE(genusToKeep(slab(1), closing));
  ShrinkWrapOptions offset;
  offset.offsetDistance = 0.1;
  EXPECT_FALSE(genusToKeep(slab(1), offset));
}
