// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Shrink-wrapping of shapes whose distances are known, wherever they lie.

#include "Checks/SurfaceMeasures.h"
#include "Errors.h"
#include "Mesh/MeshQuality.h"
#include "Remeshing/RemeshingShapes.h"
#include "Remeshing/TargetSamples.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Tubes.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace evolving;
using namespace evolving::wraps;

SurfaceMesh fineTorus()
{
  return shapes::torus(96, 48, 1.0, 0.4);
}

SurfaceMesh brick()
{
  return shapes::triangleBox(4, Vec3(1.0, 0.8, 0.6));
}

TEST(ShrinkWrapAccuracy, OfASphereIsOfSecondOrder)
{
  const SurfaceMesh sphere = icosphere(5);
  double last = 0.0;
  for (const double edge : { 0.3, 0.15 })
  {
    const SurfaceMesh result = wrap(sphere, quick(edge));
    expectSound(result, 0);
    const double distance = checks::hausdorff(result, sphere, 0.04);
    // The middle of an equilateral triangle between points of the sphere is L^2 / 6 below it, the
    // mean of it L^2 / 8: the fit takes the mean away.
    EXPECT_LT(distance, 1.2 * edge * edge / 6.0);
    const double missing = signedVolume(sphere) - signedVolume(result);
    EXPECT_LT(std::abs(missing), 0.1 * edge * edge / 8.0 * surfaceArea(sphere));
    if (last > 0.0)
    {
      EXPECT_GT(std::log2(last / distance), 1.6);
    }
    last = distance;
  }
}

TEST(ShrinkWrapAccuracy, OfATorus)
{
  const SurfaceMesh result = wrap(fineTorus(), quick(0.1, 64));
  expectSound(result, 1);
  // Curvature 2.5: interpolation would be off by k L^2 / 6 = 0.0042.
  EXPECT_LT(checks::hausdorff(result, fineTorus(), 0.04), 0.005);
  EXPECT_NEAR(signedVolume(result), signedVolume(fineTorus()), 0.002 * signedVolume(fineTorus()));
}

TEST(ShrinkWrapAccuracy, OfABoxWithoutItsEdges)
{
  const SurfaceMesh result = wrap(brick(), quick(0.1, 64));
  expectSound(result, 0);
  // An edge that a triangle cuts across: L / 2 in depth at most.
  EXPECT_LT(checks::hausdorff(result, brick(), 0.03), 0.5 * 0.1);
  EXPECT_NEAR(signedVolume(result), signedVolume(brick()), 0.005 * signedVolume(brick()));
  // Beyond two elements from the edges it lies on the sides.
  double farthest = 0.0;
  for (const Vec3& p : result.points)
  {
    const Vec3 inside = Vec3(1.0, 0.8, 0.6) - p.cwiseAbs();
    if ((inside.array() < 0.25).count() == 1)
    {
      farthest = std::max(farthest, std::abs(inside.minCoeff()));
    }
  }
  EXPECT_LT(farthest, 0.001);
}

struct Shape
{
  const char* name;
  SurfaceMesh mesh;
  Index genus;
};

class ShrinkWrapShape : public testing::TestWithParam<Shape>
{
};

/// To 0.01 % of the diagonal, at every vertex.
TEST_P(ShrinkWrapShape, OffsetDistanceIsThatOfEveryVertex)
{
  const SurfaceMesh& target = GetParam().mesh;
  const double diagonal = boundingBox(target).diagonal().norm();
  const AABBTree tree(target);
  for (const double offset : { 0.02, 0.2 })
  {
    ShrinkWrapOptions options = quick(0.1, 64);
    options.offsetDistance = offset;
    const SurfaceMesh result = wrap(target, options);
    expectSound(result, GetParam().genus);
    double largest = 0.0;
    for (const Vec3& p : result.points)
    {
      const double distance = std::sqrt(tree.closest(p).at.squaredDistance);
      largest = std::max(largest, std::abs(distance - offset));
    }
    EXPECT_LT(largest, 0.0001 * diagonal) << offset;
  }
}

TEST_P(ShrinkWrapShape, IsAsGoodOnAnyScaleAnywhere)
{
  const SurfaceMesh& target = GetParam().mesh;
  const double diagonal = boundingBox(target).diagonal().norm();
  const SurfaceMesh result = wrap(target, quick(0.12));
  const double error = checks::hausdorff(result, target, 0.05);
  const auto expectAlike = [&](const SurfaceMesh& changed, double scale)
  {
    const SurfaceMesh other = wrap(changed, quick(0.12 * scale));
    expectSound(other, GetParam().genus);
    EXPECT_NEAR(other.vertexCount(), result.vertexCount(), 0.05 * result.vertexCount());
    EXPECT_LT(checks::hausdorff(other, changed, 0.05 * scale), (1.5 * error + 0.001) * scale);
    EXPECT_NEAR(signedVolume(other) / std::pow(scale, 3), signedVolume(result),
      0.005 * std::abs(signedVolume(result)));
  };
  const Vec3 away = 100.0 * diagonal * Vec3(0.6, -0.48, 0.64);
  expectAlike(shapes::transformed(target, 1e-4, Vec3::Zero()), 1e-4);
  expectAlike(shapes::transformed(target, 1e4, 1e4 * away), 1e4);
  expectAlike(shapes::transformed(target, 1.0, away), 1.0);
  expectAlike(shapes::mapped(target, shapes::someRotation()), 1.0);
}

TEST_P(ShrinkWrapShape, HasTheSameBitsOnAnyThreads)
{
  const ShrinkWrapOptions options = quick(0.2, 32);
  const SurfaceMesh serial = wrap(GetParam().mesh, options);
  for (const int threads : { 1, 2, 4 })
  {
    const auto seed = static_cast<unsigned>(threads);
    EXPECT_TRUE(wrap(GetParam().mesh, options, threadedExecution(threads, seed)) == serial);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, ShrinkWrapShape,
  testing::Values(Shape{ "Sphere", icosphere(4), 0 }, Shape{ "Torus", fineTorus(), 1 },
    Shape{ "Box", brick(), 0 }, Shape{ "Ell", shapes::ell(), 0 }),
  [](const testing::TestParamInfo<Shape>& shape) { return std::string(shape.param.name); });

TEST(ShrinkWrapAccuracy, CreasesOfAnOffsetStayAtTheOffset)
{
  // In the concave crease the offset surface has an edge, half an offset's sqrt(2) from the
  // target's crease in each coordinate; the result comes as near as its elements allow.
  ShrinkWrapOptions options = quick(0.1, 64);
  options.offsetDistance = 0.2;
  const SurfaceMesh result = wrap(shapes::ell(), options);
  const AABBTree tree(result);
  const Vec3 crease(1.2, 1.2, 0.5);
  EXPECT_LT(std::sqrt(tree.closest(crease).at.squaredDistance), 0.1);
  // Nowhere is any point of it nearer to the target than that.
  const AABBTree target(shapes::ell());
  for (const Vec3& p : samplesOf(result, 0.02))
  {
    EXPECT_GT(std::sqrt(target.closest(p).at.squaredDistance), 0.2 - 0.012);
  }
}

TEST(ShrinkWrapCancelled, LeavesNothing)
{
  int asked = 0;
  const auto stopAfter = [&asked](int limit)
  {
    asked = 0;
    return Execution(nullptr, nullptr, [&asked, limit] { return ++asked > limit; });
  };
  // How often a whole run asks; then stop after nearly none, some and nearly all of it.
  const SurfaceMesh result = wrap(icosphere(3), quick(0.25, 24), stopAfter(1 << 30));
  const int all = asked;
  ASSERT_GT(all, 20);
  for (const int limit : { 0, all / 3, all - 1 })
  {
    EXPECT_THROW(wrap(icosphere(3), quick(0.25, 24), stopAfter(limit)), Cancelled);
  }
  EXPECT_TRUE(wrap(icosphere(3), quick(0.25, 24)) == result);
}

} // namespace
