// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CapturableCreases.h"

#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

/// Two unit cubes, the second one at x = 3.
SurfaceMesh twoCubes()
{
  const SurfaceMesh cube = box(Vec3::Zero(), Vec3::Ones());
  return merged(cube, transformed(cube, 1.0, Vec3(3.0, 0.0, 0.0)));
}

} // namespace

TEST(CapturableCreases, AreTheSharpEdges)
{
  const TargetTriangles target(twoCubes());
  const FeatureOptions options;
  OmittedCreases excluded;
  const SharpEdges creases =
    capturableCreases(target, options, excludedTriangles(target, options), excluded);
  EXPECT_NEAR(lengthOf(target, creases.list()), 24.0, 1e-12);
  EXPECT_EQ(excluded.length, 0.0);
}

TEST(CapturableCreases, LeaveOutThoseOfExcludedPlacesAndSayHowMany)
{
  const TargetTriangles target(twoCubes());
  FeatureOptions options;
  options.isExcluded = [](const Vec3& point) { return point.x() > 2.0; };
  OmittedCreases excluded;
  const SharpEdges creases =
    capturableCreases(target, options, excludedTriangles(target, options), excluded);
  EXPECT_NEAR(lengthOf(target, creases.list()), 12.0, 1e-12);
  EXPECT_NEAR(excluded.length, 12.0, 1e-12);
  EXPECT_GT(excluded.place.x(), 2.0);
}

TEST(CapturableCreases, OfTwoPartsAreThoseThatStandOut)
{
  // The second one is so coarse a ball that its edges fold as much as its creases would.
  SurfaceMesh mesh =
    merged(box(Vec3::Zero(), Vec3::Ones()), transformed(octahedron(), 1.0, Vec3(5.0, 0.0, 0.0)));
  const TargetTriangles target(mesh);
  FeatureOptions options;
  OmittedCreases excluded;
  const auto length = [&]()
  {
    return lengthOf(target,
      capturableCreases(target, options, excludedTriangles(target, options), excluded).list());
  };
  const double all = length();
  options.onlyDistinct = true;
  EXPECT_GT(all, 12.5);
  EXPECT_GE(length(), 12.0 - 1e-12);
  EXPECT_LE(length(), all);
}
