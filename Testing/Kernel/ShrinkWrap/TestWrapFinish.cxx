// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapFinish.h"

#include "Checks/SurfaceMeasures.h"
#include "Mesh/MeshQuality.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "ShrinkWrap/OuterRegion.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace evolving;

struct Finished
{
  DescribedTarget described;
  const WrapTarget& target = described.target;
  WrapReference reference;
  SurfaceMesh surface;

  Finished(const SurfaceMesh& mesh, const SurfaceMesh& arrived, const ShrinkWrapOptions& options,
    const Execution& execution = {})
    : described(wraps::describe(mesh, options, execution))
    , reference(target, OuterRegion(target.grid, described.fields.start, target.startLevel))
    , surface(finishWrap(arrived, target, reference, options, execution).surface)
  {
  }
};

/// A unit sphere that has arrived with bad elements.
SurfaceMesh arrived(double radius = 1.02)
{
  return shapes::transformed(shapes::shakenSphere(3, 0.2, 4), radius, Vec3::Zero());
}

TEST(WrapFinish, MakesGoodElementsOnTheTarget)
{
  const SurfaceMesh sphere = icosphere(5);
  ASSERT_LT(smallestAngle(arrived()), 30.0);
  const Finished finished(sphere, arrived(), wraps::quick());
  wraps::expectSound(finished.surface, 0);
  EXPECT_GT(smallestAngle(finished.surface), 44.5);
  // The middle of a triangle of edge L between points of the sphere is L^2 / 6 below it, and some
  // edges are longer than the mean; the mean error, L^2 / 8, is taken away.
  const double edge = meanEdgeLength(finished.surface);
  EXPECT_LT(checks::hausdorff(finished.surface, sphere, 0.03), 1.2 * edge * edge / 6.0);
  EXPECT_NEAR(signedVolume(finished.surface), signedVolume(sphere),
    0.1 * edge * edge / 8.0 * surfaceArea(sphere));
}

TEST(WrapFinish, EdgesHaveTheLengthAskedFor)
{
  for (const double length : { 0.12, 0.15, 0.25 })
  {
    const Finished finished(icosphere(5), arrived(), wraps::quick(length));
    EXPECT_NEAR(meanEdgeLength(finished.surface), length, 0.04 * length);
  }
}

TEST(WrapFinish, AdaptedSizesGiveAsManyVerticesSmallerWhereItIsCurved)
{
  // Curvatures from 0.25 to 2.
  const SurfaceMesh target = shapes::ellipsoid(5, Vec3(1.0, 1.0, 2.0));
  const SurfaceMesh start = shapes::ellipsoid(3, Vec3(1.0, 1.0, 2.0));
  ShrinkWrapOptions options = wraps::quick(0.15);
  const Finished uniform(target, start, options);
  options.adaptToCurvature = true;
  const Finished adapted(target, start, options);
  wraps::expectSound(adapted.surface, 0);
  EXPECT_NEAR(adapted.surface.vertexCount(), uniform.surface.vertexCount(),
    0.1 * uniform.surface.vertexCount());
  const auto nearTips = [](const SurfaceMesh& mesh)
  {
    return static_cast<double>(std::count_if(
      mesh.points.begin(), mesh.points.end(), [](const Vec3& p) { return std::abs(p.z()) > 1.7; }));
  };
  EXPECT_GT(nearTips(adapted.surface), 1.3 * nearTips(uniform.surface));
}

TEST(WrapFinish, SaysWhetherElementsFollowTheCurvature)
{
  // No element has an angle of 61 degrees: with such a tuning each run is worse than none.
  const SurfaceMesh target = shapes::ellipsoid(5, Vec3(1.0, 1.0, 2.0));
  ShrinkWrapOptions options = wraps::quick(0.2);
  options.adaptToCurvature = true;
  for (const double leastAngle : { 15.0, 61.0 })
  {
    WrapTuning tuning;
    tuning.finish.leastAngleOfAdapted = leastAngle;
    const ShrinkWrapProblem problem = prepareShrinkWrap(target, options, {}, tuning);
    const SurfaceMesh surface = wraps::run(problem);
    wraps::expectSound(surface, 0);
    EXPECT_EQ(measureWrap(surface, problem, {}).adaptation.isLeftOut, leastAngle > 60.0);
  }
}

TEST(WrapFinish, VerticesLandAtTheOffset)
{
  ShrinkWrapOptions options = wraps::quick();
  options.offsetDistance = 0.2;
  const Finished finished(icosphere(5), arrived(1.22), options);
  for (const Vec3& p : finished.surface.points)
  {
    EXPECT_NEAR(p.norm(), 1.2, 0.001); // what the target's own triangles cut off
  }
  EXPECT_GT(smallestAngle(finished.surface), 42.0);
}

TEST(WrapFinish, IsTheSameOnAnyThreads)
{
  const SurfaceMesh serial = Finished(icosphere(4), arrived(), wraps::quick(0.2)).surface;
  const Execution host = threadedExecution(4, 9);
  EXPECT_TRUE(Finished(icosphere(4), arrived(), wraps::quick(0.2), host).surface == serial);
}

} // namespace
