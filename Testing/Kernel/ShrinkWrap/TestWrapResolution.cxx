// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapResolution.h"

#include "Mesh/Angles.h"
#include "Remeshing/CoveringTriangles.h"
#include "Remeshing/TargetSamples.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "ShrinkWrap/WrapLooks.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace evolving;

namespace
{

using Samples = std::array<int, 3>;

std::optional<WrapResolution> needed(const SurfaceMesh& mesh, const ShrinkWrapOptions& options)
{
  const WrapView view(mesh, options, firstResolution(options), {}, {});
  return neededResolution(options, view);
}

/// A quick first look.
ShrinkWrapOptions sampled(int samples)
{
  ShrinkWrapOptions options;
  options.sampleDimensions = { samples, samples, samples };
  return options;
}

/// A slab of thickness 1 with square holes of side 1.
SurfaceMesh slab(int holes)
{
  std::mt19937 generator(1);
  return shapes::triangulated(shapes::slabWithHoles(holes), generator);
}

/// Of squares, turned by a right angle from bottom to top: narrow facets all around.
SurfaceMesh twistedPrism(Index layers, double height)
{
  SurfaceMesh mesh;
  for (Index i = 0; i <= layers; ++i)
  {
    for (Index k = 0; k < 4; ++k)
    {
      const double part = static_cast<double>(i) / layers;
      const double angle = 0.5 * Pi * (part + k);
      mesh.addPoint(Vec3(std::cos(angle), std::sin(angle), height * part));
      const Index next = (k + 1) % 4;
      if (i > 0)
      {
        const Index low = 4 * (i - 1);
        mesh.addFace({ low + k, low + next, low + 4 + next });
        mesh.addFace({ low + k, low + 4 + next, low + 4 + k });
      }
    }
  }
  for (const Index k : { 1, 2 })
  {
    mesh.addFace({ 0, k + 1, k });
    mesh.addFace({ 4 * layers, 4 * layers + k, 4 * layers + k + 1 });
  }
  return mesh;
}

/// Of equilateral triangles with edges of these sizes.
double pointsOn(const SurfaceMesh& mesh, const CreaseSizes& sizes)
{
  constexpr double Spacing = 0.01;
  double points = 0.0;
  for (const Vec3& p : samplesOf(mesh, Spacing))
  {
    points += coveringVertexCount(Spacing * Spacing, sizes.at(p));
  }
  return points;
}

} // namespace

TEST(WrapResolution, OfTheFirstLookIsWhatIsAskedForOr128)
{
  ShrinkWrapOptions options;
  EXPECT_EQ(firstResolution(options).samples, (Samples{ 128, 128, 128 }));
  EXPECT_EQ(firstResolution(options).edgeLength, 0.0);
  EXPECT_FALSE(firstResolution(options).beside);
  options.sampleDimensions = { 20, 0, 30 };
  options.targetEdgeLength = 0.5;
  EXPECT_EQ(firstResolution(options).samples, (Samples{ 20, 128, 30 }));
  EXPECT_EQ(firstResolution(options).edgeLength, 0.5);
}

TEST(WrapResolution, CountsTheSamplesOfAnyLook)
{
  EXPECT_EQ(mostSamples(sampled(20)), 8000);
  ShrinkWrapOptions options;
  EXPECT_EQ(mostSamples(options), 32000000);
  options.sampleDimensions = { 4096, 4096, 0 };
  EXPECT_EQ(mostSamples(options), GridIndex(4096) * 4096 * 128);
}

TEST(WrapResolution, OfASmoothModelNeedsNoSecondLook)
{
  EXPECT_FALSE(needed(icosphere(4), sampled(32)));
}

TEST(WrapResolution, FollowsTheNumberOfPoints)
{
  ShrinkWrapOptions options = sampled(32);
  options.targetNumberOfPoints = 500;
  const SurfaceMesh ball = icosphere(4);
  const auto few = needed(ball, options);
  ASSERT_TRUE(few);
  EXPECT_NEAR(few->edgeLength, coveringEdgeLength(surfaceArea(ball), 500.0), 1e-12);
  EXPECT_FALSE(few->beside);
  options.targetEdgeLength = 0.3; // has precedence
  const auto asAsked = needed(ball, options);
  EXPECT_TRUE(!asAsked || asAsked->edgeLength == 0.3);
}

TEST(WrapResolution, DoesNotCountWhatIsHidden)
{
  // Two balls inside have as much area as half of the outer one.
  const SurfaceMesh ball = icosphere(4);
  const SurfaceMesh inner = shapes::transformed(ball, 0.4, Vec3(0.45, 0.0, 0.0));
  const SurfaceMesh other = shapes::transformed(ball, 0.4, Vec3(-0.45, 0.0, 0.0));
  ShrinkWrapOptions options = sampled(32);
  const auto resolution = needed(shapes::merged(ball, shapes::merged(inner, other)), options);
  ASSERT_TRUE(resolution);
  EXPECT_NEAR(resolution->edgeLength, coveringEdgeLength(surfaceArea(ball), 9000.0), 1e-3);
}

TEST(WrapResolution, HasSmallElementsBesideCreases)
{
  const SurfaceMesh plate = shapes::box(Vec3::Zero(), Vec3(1.0, 1.0, 0.02));
  const auto resolution = needed(plate, sampled(48));
  ASSERT_TRUE(resolution && resolution->beside);
  EXPECT_NEAR(resolution->beside->smallest(), 0.5 * 0.02, 0.0015); // about two across
  EXPECT_NEAR(resolution->beside->largest(), resolution->edgeLength, 1e-12);
  ShrinkWrapOptions without = sampled(48);
  without.preserveFeatures = FeaturePreservation::Off;
  EXPECT_FALSE(needed(plate, without));
  without = sampled(48);
  without.adaptToCurvature = true;
  EXPECT_FALSE(needed(plate, without));
  without = sampled(48);
  without.offsetDistance = 0.1;
  const auto offset = needed(plate, without);
  EXPECT_TRUE(!offset || !offset->beside);
}

TEST(WrapResolution, KeepsToTheBudgetWhereCreasesAreEverywhere)
{
  const SurfaceMesh mesh = twistedPrism(40, 4.0);
  const std::optional<WrapResolution> resolution = needed(mesh, {});
  ASSERT_TRUE(resolution && resolution->beside);
  EXPECT_LT(pointsOn(mesh, *resolution->beside), 60000.0);
  EXPECT_GT(pointsOn(mesh, *resolution->beside), 20000.0);
}

TEST(WrapResolution, IsFinerWhereEdgesAre)
{
  ShrinkWrapOptions options;
  options.sampleDimensions = { 0, 0, 0 };
  options.targetEdgeLength = 0.01;
  const auto fine = needed(icosphere(4), options);
  ASSERT_TRUE(fine);
  EXPECT_GT(fine->samples[0], 200);
  options.sampleDimensions = { 40, 40, 40 }; // are asked for, and stay
  EXPECT_FALSE(needed(icosphere(4), options));
}

TEST(WrapResolution, BecomesFinerUntilItMustNot)
{
  ShrinkWrapOptions options = sampled(0);
  options.targetEdgeLength = 0.1;
  WrapResolution tried = firstResolution(options);
  tried.samples = { 24, 24, 24 };
  double cell = 1.0;
  int looks = 0;
  for (std::optional<WrapResolution> next = tried; next; ++looks)
  {
    tried = *next;
    const WrapView view(icosphere(3), options, tried, {}, {});
    EXPECT_LT(view.target()->cellSize(), cell);
    cell = view.target()->cellSize();
    next = finerResolution(options, tried, view);
  }
  EXPECT_GT(looks, 2);
  EXPECT_LT(cell, 0.1 / 4.0);
  options.sampleDimensions = { 24, 24, 24 };
  tried.samples = { 24, 24, 24 };
  EXPECT_FALSE(finerResolution(options, tried, WrapView(icosphere(3), options, tried, {}, {})));
}

TEST(WrapResolution, OfPointsFollowsTheirNumberOnly)
{
  ShrinkWrapOptions options = sampled(32);
  SurfaceMesh points;
  points.points = icosphere(4).points;
  const WrapView view(points, options, firstResolution(options), {}, {});
  EXPECT_FALSE(neededForPoints(options, view));
  options.targetNumberOfPoints = 700;
  const auto asked = neededForPoints(options, view);
  ASSERT_TRUE(asked);
  EXPECT_NEAR(asked->edgeLength, coveringEdgeLength(4.0 * 3.14159, 700.0), 0.01);
}

TEST(WrapResolution, GivesAboutAsManyPointsAsAreAskedFor)
{
  ShrinkWrapOptions options;
  options.targetNumberOfPoints = 2000;
  for (const SurfaceMesh& mesh : { icosphere(4), slab(2) })
  {
    const Index points = wraps::wrap(mesh, options).vertexCount();
    EXPECT_GT(points, 1600);
    EXPECT_LT(points, 2400);
  }
}

TEST(WrapResolution, OfANeedleDoesNotGrowAsItsAreaShrinks)
{
  SurfaceMesh needle;
  needle.points = { Vec3::Zero(), Vec3(1e-6, 0, 0), Vec3(0, 0.1, 0) };
  needle.addFace({ 0, 1, 2 });
  ShrinkWrapOptions options;
  options.targetNumberOfPoints = 900;
  EXPECT_NEAR(needed(needle, options)->edgeLength, 0.0025, 1e-9);
  const Index points = wraps::wrap(needle, options).vertexCount();
  EXPECT_GT(points, 100);
  EXPECT_LT(points, 1800);
}

TEST(WrapResolution, KeepsHolesNarrowerThanTheDefaultGridSees)
{
  // Of a plate 24 holes' sides long: elements are as large as holes, cells larger than half of one.
  SurfaceMesh plate = slab(12);
  ShrinkWrapOptions options;
  options.targetNumberOfPoints = 3000;
  wraps::expectSound(wraps::wrap(plate, options), 12, 1, 20.0);
}

TEST(WrapResolution, FollowsCreasesOfPartsWithNarrowGaps)
{
  // Two plates so near that the first look sees one: sides of both are hidden, but cross nothing.
  const SurfaceMesh lower = shapes::triangleBox(8, Vec3(1, 1, 0.1));
  const SurfaceMesh upper = shapes::transformed(lower, 1.0, Vec3(0, 0, 0.202));
  ShrinkWrapOptions options;
  options.targetNumberOfPoints = 600;
  const SeenTarget seen = lookAsNeeded(shapes::merged(lower, upper), options, {}, {});
  const WrapTarget& target = *seen.view->target();
  ASSERT_TRUE(target.besideCreases);
  EXPECT_LT(target.shortestEdge(), 0.9 * target.edgeLength);
}
