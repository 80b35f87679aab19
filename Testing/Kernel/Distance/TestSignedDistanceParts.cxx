// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SignedDistance.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Tubes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

/// Parts that cut the surface, miss it, and have one sample along an axis.
const Extent Parts[] = { { 0, 12, 0, 10, 0, 9 }, { 13, 27, 5, 20, 3, 18 }, { 0, 3, 0, 3, 0, 3 },
  { 5, 25, 11, 11, 2, 20 }, { 14, 14, 12, 12, 11, 11 }, { 0, 27, 0, 24, 0, 22 } };

/// Calls check(part value, whole value) for each entry of an array with some components.
template <typename Value, typename Check>
void compare(const std::vector<Value>& ofPart, const std::vector<Value>& ofWhole, int components,
  const DistanceGrid& grid, const Extent& part, const Check& check)
{
  const DistanceGrid partGrid = grid.part(part);
  ASSERT_EQ(ofPart.size(), static_cast<std::size_t>(components * partGrid.sampleCount()));
  for (int k = part[4]; k <= part[5]; ++k)
  {
    for (int j = part[2]; j <= part[3]; ++j)
    {
      for (int i = part[0]; i <= part[1]; ++i)
      {
        for (int c = 0; c < components; ++c)
        {
          const auto p = static_cast<std::size_t>(components * partGrid.index(i, j, k) + c);
          const auto w = static_cast<std::size_t>(components * grid.index(i, j, k) + c);
          check(ofPart[p], ofWhole[w]);
        }
      }
    }
  }
}

const auto Same = [](auto a, auto b) { ASSERT_EQ(a, b); };

SurfaceMesh holedTorus()
{
  return without(torus(40, 20, 1.0, 0.4), [](Index face) { return face % 13 == 0; });
}

DistanceGrid gridOf(const SurfaceMesh& mesh)
{
  return gridAround(boundingBox(mesh), { 28, 25, 23 }, 0.1);
}

} // namespace

TEST(SignedDistanceParts, AreThoseOfTheWholeBitForBit)
{
  for (const SurfaceMesh& mesh : { torus(40, 20, 1.0, 0.4), holedTorus() })
  {
    const DistanceGrid grid = gridOf(mesh);
    for (int n = 0; n < 8; ++n)
    {
      constexpr SignMethod Signs[] = { SignMethod::Automatic, SignMethod::Pseudonormal,
        SignMethod::WindingNumber, SignMethod::Unsigned };
      SignedDistanceOptions options;
      options.method = n < 4 ? DistanceMethod::ClosestPoint : DistanceMethod::BruteForce;
      options.sign = Signs[n % 4];
      options.closestPoint = options.closestFace = options.gradient = true;
      options.bandWidth = 6.0;
      ASSERT_TRUE(canComputeParts(options));
      const auto whole = signedDistance(mesh, grid, grid.extent, options);
      for (const Extent& part : Parts)
      {
        const auto result = signedDistance(mesh, grid, part, options);
        compare(result.distance, whole.distance, 1, grid, part, Same);
        compare(result.closestFace, whole.closestFace, 1, grid, part, Same);
        compare(result.closestPoint, whole.closestPoint, 3, grid, part, Same);
        compare(result.gradient, whole.gradient, 3, grid, part, Same);
        EXPECT_EQ(result.sign, whole.sign);
        EXPECT_EQ(result.signReason, whole.signReason);
      }
    }
  }
}

TEST(SignedDistanceParts, OfASmoothedFieldAreThoseOfTheWhole)
{
  const SurfaceMesh mesh = torus(40, 20, 1.0, 0.4);
  const DistanceGrid grid = gridOf(mesh);
  SignedDistanceOptions options;
  options.method = DistanceMethod::BruteForce;
  options.smoothingSigma = 1.2;
  options.gradient = true;
  const auto whole = signedDistance(mesh, grid, grid.extent, options);
  for (const Extent& part : Parts)
  {
    const auto result = signedDistance(mesh, grid, part, options);
    compare(result.distance, whole.distance, 1, grid, part, Same);
    compare(result.gradient, whole.gradient, 3, grid, part, Same);
  }
}

TEST(SignedDistanceParts, OfABandAreThoseOfTheWhole)
{
  // Without other arrays nothing is computed beyond the band, signs included.
  for (const SurfaceMesh& mesh : { torus(40, 20, 1.0, 0.4), holedTorus() })
  {
    const DistanceGrid grid = gridAround(boundingBox(mesh), { 60, 60, 40 }, 0.4);
    SignedDistanceOptions options;
    const auto all = signedDistance(mesh, grid, grid.extent, options);
    options.bandWidth = 1.5;
    const auto band = static_cast<float>(1.5 * grid.spacing.x());
    const auto whole = signedDistance(mesh, grid, grid.extent, options);
    compare(whole.distance, all.distance, 1, grid, grid.extent,
      [band](float a, float b) { ASSERT_EQ(a, std::clamp(b, -band, band)); });
    for (const Extent& part : Parts)
    {
      const auto result = signedDistance(mesh, grid, part, options);
      compare(result.distance, whole.distance, 1, grid, part, Same);
    }
  }
}

TEST(SignedDistanceParts, OfMethodsThatNeedTheWholeGridAreCutFromIt)
{
  const SurfaceMesh mesh = torus(40, 20, 1.0, 0.4);
  const DistanceGrid grid = gridOf(mesh);
  SignedDistanceOptions flood;
  flood.sign = SignMethod::FloodFill;
  SignedDistanceOptions sweeping;
  sweeping.method = DistanceMethod::FastSweeping;
  for (SignedDistanceOptions options : { flood, sweeping })
  {
    EXPECT_FALSE(canComputeParts(options));
    options.closestPoint = options.closestFace = true;
    const auto whole = signedDistance(mesh, grid, grid.extent, options);
    for (const Extent& part : Parts)
    {
      const auto result = signedDistance(mesh, grid, part, options);
      compare(result.distance, whole.distance, 1, grid, part, Same);
      compare(result.closestFace, whole.closestFace, 1, grid, part, Same);
      compare(result.closestPoint, whole.closestPoint, 3, grid, part, Same);
    }
  }
}

TEST(SignedDistanceParts, MayHaveExtentsThatBeginAnywhere)
{
  const SurfaceMesh mesh = torus(40, 20, 1.0, 0.4);
  const DistanceGrid grid = gridOf(mesh);
  DistanceGrid shifted = grid;
  shifted.extent = { -5, 22, 7, 31, 100, 122 };
  shifted.origin -= grid.spacing.cwiseProduct(Vec3(-5, 7, 100));
  for (const auto method : { DistanceMethod::ClosestPoint, DistanceMethod::FastSweeping })
  {
    SignedDistanceOptions options;
    options.method = method;
    const auto expected = signedDistance(mesh, grid, grid.extent, options).distance;
    const auto found = signedDistance(mesh, shifted, shifted.extent, options).distance;
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t s = 0; s < found.size(); ++s)
    {
      ASSERT_NEAR(found[s], expected[s], 1e-5F);
    }
  }
}
