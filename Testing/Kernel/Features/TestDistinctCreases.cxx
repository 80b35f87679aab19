// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/DistinctCreases.h"

#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <vector>

using namespace evolving;

namespace
{

struct Kept
{
  std::size_t sharp = 0;
  std::size_t kept = 0;
};

Kept keptOf(const SurfaceMesh& surface, double angle)
{
  const TargetTriangles target(surface);
  SharpEdges sharp(target, angle, false);
  const std::size_t all = sharp.list().size();
  keepDistinctCreases(target, sharp);
  return { all, sharp.list().size() };
}

void expectAll(const SurfaceMesh& surface, double angle = 45.0)
{
  const Kept kept = keptOf(surface, angle);
  EXPECT_GT(kept.sharp, 0U);
  EXPECT_EQ(kept.kept, kept.sharp);
}

void expectNone(const SurfaceMesh& surface, double angle = 45.0)
{
  const Kept kept = keptOf(surface, angle);
  EXPECT_GT(kept.sharp, 0U);
  EXPECT_EQ(kept.kept, 0U);
}

} // namespace

TEST(DistinctCreases, OfFlatAndRoundSidesAreAll)
{
  expectAll(shapes::triangleBox(4, Vec3(1, 2, 3)));
  expectAll(shapes::cylinder());
  expectAll(shapes::hexagonalPrism());
  expectAll(shapes::octahedron()); // no edge beside its creases is anything else
  expectAll(shapes::ell());
}

TEST(DistinctCreases, OfCoarseOrRoughRoundThingsAreNone)
{
  // Folds of an icosphere are alike, so that those above their mean are no creases.
  expectNone(shapes::bumpySphere(1), 20.0);
  for (const unsigned seed : { 1U, 2U, 3U })
  {
    expectNone(shapes::shaken(icosphere(3), 0.04, seed));
  }
}

TEST(DistinctCreases, OfABoxSurviveABitOfNoise)
{
  for (const double amount : { 1e-6, 1e-3 })
  {
    expectAll(shapes::shaken(shapes::triangleBox(4, Vec3(1, 1, 1)), amount, 5));
  }
}

TEST(DistinctCreases, AreJudgedPartByPart)
{
  const SurfaceMesh box = shapes::triangleBox(4, Vec3(1, 2, 3));
  const SurfaceMesh rough =
    shapes::transformed(shapes::shaken(icosphere(3), 0.04, 1), 1.0, Vec3(9, 0, 0));
  const Kept both = keptOf(shapes::merged(box, rough), 45.0);
  EXPECT_EQ(both.kept, keptOf(box, 45.0).kept);
  EXPECT_GT(both.sharp, both.kept);
}

TEST(DistinctCreases, DoNotDependOnSizeOrPlace)
{
  const SurfaceMesh rough = shapes::shaken(shapes::cylinder(), 0.002, 4);
  const Kept kept = keptOf(rough, 45.0);
  for (const double scale : { 1e-6, 1e6 })
  {
    const Kept other = keptOf(shapes::transformed(rough, scale, scale * Vec3(3, -2, 5)), 45.0);
    EXPECT_EQ(other.kept, kept.kept);
    EXPECT_EQ(other.sharp, kept.sharp);
  }
}
