// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What becomes of the holes and handles of a target, and what is said of it.

#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Tubes.h"
#include "ShrinkWrap/Shortcomings.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <string>

using namespace evolving;

namespace
{

SurfaceMesh slab(int holes)
{
  std::mt19937 generator(1);
  return shapes::triangulated(shapes::slabWithHoles(holes), generator);
}

/// What is said of the genus; empty when nothing is.
std::string saidOfGenus(const SurfaceReport& report, double edgeLength)
{
  for (const std::string& sentence : shortcomings(report, edgeLength))
  {
    if (sentence.find("genus") != std::string::npos)
    {
      return sentence;
    }
  }
  return "";
}

std::string saidOfGenus(const SurfaceMesh& target, const ShrinkWrapOptions& options)
{
  const ShrinkWrapProblem problem = prepareShrinkWrap(target, options);
  return saidOfGenus(examineWrap(wraps::run(problem), problem), problem.edgeLength);
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

TEST(WrapGenus, IsKeptWithoutAWord)
{
  EXPECT_EQ(saidOfGenus(icosphere(3), wraps::quick()), "");
  EXPECT_EQ(saidOfGenus(slab(2), wraps::quick(0.2, 48)), "");
}

TEST(WrapGenus, HolesThatWereClosedAreSaid)
{
  // Holes of one unit in a slab of eleven, with triangles of two.
  const std::string said = saidOfGenus(slab(5), wraps::quick(1.6, 24));
  EXPECT_NE(said.find("of genus 5, the result has genus 0 in 1 part"), std::string::npos) << said;
  EXPECT_NE(said.find("closed or lost"), std::string::npos) << said;
}

TEST(WrapGenus, SentencesFitWhatHappened)
{
  SurfaceReport report;
  report.isClosed = true;
  report.isManifold = true;
  report.minAngle = 40.0;
  report.components = 1;
  report.genus = 2;
  report.wantedGenus = 2;
  EXPECT_EQ(saidOfGenus(report, 1.0), "");
  report.genus = 3;
  EXPECT_NE(saidOfGenus(report, 1.0).find("joined"), std::string::npos);
  report.genus = 2;
  report.components = 4;
  EXPECT_NE(saidOfGenus(report, 1.0).find("in 4 parts: places thinner"), std::string::npos);
  report.wantedGenus.reset();
  EXPECT_EQ(saidOfGenus(report, 1.0), "");
}
