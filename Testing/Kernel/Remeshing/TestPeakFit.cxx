// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/PeakFit.h"

#include "Checks/SurfaceMeasures.h"
#include "Mesh/MeshQuality.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Remeshing/SizingField.h"
#include "Remeshing/TargetSamples.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

constexpr double Slope = 0.5;

/// Of the samples by which deviations are measured.
constexpr double Spacing = 0.03;

/// A cone over the unit disc, its tip at height Slope.
SurfaceMesh cone(Index rings)
{
  SurfaceMesh mesh = shapes::disc(rings);
  for (Vec3& p : mesh.points)
  {
    p.z() = Slope * (1.0 - p.norm());
  }
  return mesh;
}

/// The same, coarse and with its tip cut off.
EditableSurface bluntCone()
{
  SurfaceMesh mesh = cone(4);
  mesh.points[0].z() -= 0.1;
  return shapes::sized(mesh, 0.25);
}

TEST(PeakFit, ReachesATip)
{
  const SurfaceMesh target = cone(24);
  EditableSurface surface = bluntCone();
  const double forth = checks::farthest(target, surface.mesh(), Spacing);
  const double back = checks::farthest(surface.mesh(), target, Spacing);
  EXPECT_EQ(fitPeaks(surface, OffsetReference(target, 0.0), samplesOf(target, 0.05), {}), 1);
  EXPECT_LT((surface.point(0) - Vec3(0.0, 0.0, Slope)).norm(), 0.02);
  EXPECT_LT(checks::farthest(target, surface.mesh(), Spacing), 0.5 * forth);
  EXPECT_LT(checks::farthest(surface.mesh(), target, Spacing), 0.5 * back);
}

TEST(PeakFit, LeavesAFittedSurfaceAlone)
{
  const SurfaceMesh target = icosphere(4);
  EditableSurface surface = shapes::sized(icosphere(3), 0.15);
  const SurfaceMesh before = surface.mesh();
  EXPECT_EQ(fitPeaks(surface, OffsetReference(target, 0.0), samplesOf(target, 0.05), {}), 0);
  EXPECT_TRUE(surface.mesh() == before);
}

TEST(PeakFit, GoesAfterNoSampleThatIsTooFar)
{
  const SurfaceMesh target = cone(24);
  EditableSurface surface = bluntCone();
  PeakFitOptions options;
  options.farthest = 0.08; // the tip is 0.09 away
  EXPECT_EQ(fitPeaks(surface, OffsetReference(target, 0.0), samplesOf(target, 0.05), options), 0);
  // Of a valley as deep, seen from above, the other bound decides.
  EditableSurface valley(reversed(bluntCone().mesh()));
  setUniformSizes(valley, 0.25);
  options = {};
  options.farthest = 0.0;
  options.deepest = 0.08;
  EXPECT_EQ(fitPeaks(valley, OffsetReference(target, 0.0), samplesOf(target, 0.05), options), 0);
  options.deepest = 0.1;
  EXPECT_EQ(fitPeaks(valley, OffsetReference(target, 0.0), samplesOf(target, 0.05), options), 1);
}

TEST(PeakFit, AnglesStayAboveTheirBound)
{
  for (const double bound : { 38.0, 50.0 })
  {
    // A target with many bumps higher than the surface has vertices for.
    SurfaceMesh target = icosphere(4);
    for (Vec3& p : target.points)
    {
      p *= 1.0 + 0.08 * std::sin(9.0 * p.x()) * std::sin(9.0 * p.y() + 1.0);
    }
    EditableSurface surface = shapes::sized(icosphere(3), 0.15);
    const double before = smallestAngle(surface.mesh());
    PeakFitOptions options;
    options.leastAngle = bound;
    const OffsetReference reference(target, 0.0);
    const Index moved = fitPeaks(surface, reference, samplesOf(target, 0.08), options);
    EXPECT_GT(moved, bound < 50.0 ? 20 : 0);
    EXPECT_GE(smallestAngle(surface.mesh()), std::min(before, bound) - 1e-9);
    EXPECT_LE(checks::farthest(target, surface.mesh(), Spacing),
      checks::farthest(target, icosphere(3), Spacing));
    expectSound(surface, { 2, 0, 1 });
  }
}

TEST(PeakFit, FeaturesAndPinsStay)
{
  const SurfaceMesh target = cone(24);
  EditableSurface surface = bluntCone();
  surface.setPinned(0);
  const SurfaceMesh before = surface.mesh();
  fitPeaks(surface, OffsetReference(target, 0.0), samplesOf(target, 0.05), {});
  for (const Index v : verticesOf(surface))
  {
    if (surface.isBoundary(v) || surface.isPinned(v))
    {
      EXPECT_EQ(surface.point(v), before.points[static_cast<std::size_t>(v)]);
    }
  }
}

TEST(PeakFit, AnEmptySurfaceHasNothingToMove)
{
  EditableSurface empty{ SurfaceMesh() };
  const SurfaceMesh target = icosphere(1);
  EXPECT_EQ(fitPeaks(empty, OffsetReference(target, 0.0), target.points, {}), 0);
  EditableSurface surface = bluntCone();
  EXPECT_EQ(fitPeaks(surface, OffsetReference(target, 0.0), {}, {}), 0);
}

TEST(PeakFit, OnAnEmptyReferenceNoPeakIsReachedButSamplesAre)
{
  // A reference without faces is wherever one asks: only the samples have a distance.
  EditableSurface surface = bluntCone();
  const SurfaceMesh target = cone(24);
  EXPECT_EQ(fitPeaks(surface, OffsetReference({}, 0.0), samplesOf(target, 0.05), {}), 1);
  EXPECT_LT((surface.point(0) - Vec3(0.0, 0.0, Slope)).norm(), 0.02);
}

TEST(PeakFit, IsTheSameOnAnyThreads)
{
  const SurfaceMesh target = shapes::bumpySphere(4);
  const OffsetReference reference(target, 0.0);
  const std::vector<Vec3> samples = samplesOf(target, 0.1);
  PeakFitOptions options;
  options.tolerance = 0.02;
  options.leastAngle = 20.0;
  EditableSurface serial = shapes::sized(shapes::bumpySphere(3), 0.15);
  ASSERT_GT(fitPeaks(serial, reference, samples, options), 20);
  for (const int threads : { 2, 8 })
  {
    EditableSurface surface = shapes::sized(shapes::bumpySphere(3), 0.15);
    fitPeaks(surface, reference, samples, options, threadedExecution(threads, 6));
    EXPECT_TRUE(surface.mesh() == serial.mesh());
  }
}

} // namespace
