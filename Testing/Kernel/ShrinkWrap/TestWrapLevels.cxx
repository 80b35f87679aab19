// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapLevels.h"

#include "ShrinkWrap/SheetOpenness.h"
#include "ShrinkWrap/SheetShapes.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

using namespace evolving;
using namespace evolving::wraps;

namespace
{

constexpr double Offset = 0.01;
constexpr double Wall = 0.05;

WrapLevels levelsOf(const ReachedTarget& target, double offset = Offset, double wall = Wall,
  const Execution& execution = {})
{
  const std::vector<char> noneHasInside(at(target.mesh.faceCount()), 0);
  return wrapLevels(
    target.mesh, target.tree, noneHasInside, target.region, offset, wall, execution);
}

Vec3 middleOf(const SurfaceMesh& mesh, Index face)
{
  return (mesh.facePoint(face, 0) + mesh.facePoint(face, 1) + mesh.facePoint(face, 2)) / 3.0;
}

void expectEverywhere(const WrapLevels& levels, double level)
{
  for (Index t = 0; t < levels.triangles.faceCount(); ++t)
  {
    const std::array<double, 3> expected{ level, level, level };
    EXPECT_EQ(levels.atCorners[at(t)], expected) << t;
    EXPECT_EQ(levels.maximum(t), level);
  }
}

} // namespace

TEST(WrapLevels, OfAClosedSurfaceAreItsOffset)
{
  const ReachedTarget target(icosphere(3));
  const WrapLevels levels = levelsOf(target);
  EXPECT_TRUE(levels.triangles == target.mesh);
  expectEverywhere(levels, Offset);
}

TEST(WrapLevels, OfASheetAreTheWallUnlessTheOffsetIsLarger)
{
  const ReachedTarget target(plate(3));
  const WrapLevels levels = levelsOf(target);
  EXPECT_TRUE(levels.triangles == target.mesh);
  expectEverywhere(levels, Wall);
  expectEverywhere(levelsOf(target, 2.0 * Wall), 2.0 * Wall);
}

TEST(WrapLevels, OfAPartlyCoveredSheetFollowItsOpenness)
{
  const ReachedTarget target(coveredPlate(1));
  const SheetOpenness openness(target.tree, target.region);
  const WrapLevels levels = levelsOf(target);
  for (Index t = 0; t < levels.triangles.faceCount(); ++t)
  {
    // Of the two triangles of the plate the first one is below the diagonal.
    const Vec3 middle = middleOf(levels.triangles, t);
    const Index whole = middle.y() > middle.x() ? 1 : 0;
    for (Index k = 0; k < 3; ++k)
    {
      const Vec3& p = levels.triangles.facePoint(t, k);
      const double level = levels.atCorners[at(t)][at(k)];
      const double open = middle.z() == 0.0 ? openness.at(whole, p) : 0.0;
      EXPECT_EQ(level, std::max(Offset, Wall * open)) << p.transpose();
      if (middle.z() == 0.0 && std::abs(p.x()) > 0.35 && std::abs(p.x()) < 0.95)
      {
        EXPECT_EQ(level, p.x() < 0.0 ? Wall : Offset) << p.transpose();
      }
    }
  }
}

TEST(WrapLevels, CutTrianglesAreTheWholeInPartsNoLargerThanTheBall)
{
  const ReachedTarget target(coveredPlate(1));
  const WrapLevels levels = levelsOf(target);
  const SurfaceMesh& parts = levels.triangles;
  EXPECT_GT(parts.faceCount(), target.mesh.faceCount());
  EXPECT_EQ(levels.atCorners.size(), static_cast<std::size_t>(parts.faceCount()));
  EXPECT_TRUE(
    std::equal(target.mesh.points.begin(), target.mesh.points.end(), parts.points.begin()));
  double area = 0.0;
  for (Index t = 0; t < parts.faceCount(); ++t)
  {
    const Vec3& a = parts.facePoint(t, 0);
    const Vec3& b = parts.facePoint(t, 1);
    const Vec3& c = parts.facePoint(t, 2);
    if (a.z() == 0.0)
    {
      const double longest = std::max({ (b - a).norm(), (c - b).norm(), (a - c).norm() });
      EXPECT_LE(longest, target.radius);
      const double signedArea = 0.5 * (b - a).cross(c - a).z();
      EXPECT_GT(signedArea, 0.0); // turned as the whole
      area += signedArea;
    }
  }
  EXPECT_NEAR(area, 4.0, 1e-12);
}

TEST(WrapLevels, PartsThatMeetAgree)
{
  // Inside one triangle of the target the level is one function of the place.
  const ReachedTarget target(coveredPlate(1));
  const WrapLevels levels = levelsOf(target);
  std::map<std::tuple<double, double, bool>, double> known;
  int met = 0;
  for (Index t = 0; t < levels.triangles.faceCount(); ++t)
  {
    const Vec3 middle = middleOf(levels.triangles, t);
    for (Index k = 0; k < 3 && middle.z() == 0.0; ++k)
    {
      const Vec3& p = levels.triangles.facePoint(t, k);
      const double level = levels.atCorners[at(t)][at(k)];
      const auto [entry, isNew] =
        known.emplace(std::make_tuple(p.x(), p.y(), middle.y() > middle.x()), level);
      EXPECT_EQ(entry->second, level) << p.transpose();
      met += isNew ? 0 : 1;
    }
  }
  EXPECT_GT(met, 100);
}

TEST(WrapLevels, ScaleWithTheUnitBitForBit)
{
  const WrapLevels expected = levelsOf(ReachedTarget(coveredPlate(2)));
  const double scale = 0x1p12;
  const WrapLevels scaled =
    levelsOf(ReachedTarget(coveredPlate(2), scale), scale * Offset, scale * Wall);
  EXPECT_EQ(scaled.triangles.cornerVertices, expected.triangles.cornerVertices);
  ASSERT_EQ(scaled.atCorners.size(), expected.atCorners.size());
  for (std::size_t t = 0; t < expected.atCorners.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_EQ(scaled.atCorners[t][k], scale * expected.atCorners[t][k]);
    }
  }
}

TEST(WrapLevels, AreTheSameOnAnyThreads)
{
  const ReachedTarget target(coveredPlate(24));
  const WrapLevels expected = levelsOf(target);
  for (const int threads : { 1, 2, 8 })
  {
    const WrapLevels levels = levelsOf(target, Offset, Wall, threadedExecution(threads, 3));
    EXPECT_TRUE(levels.triangles == expected.triangles) << threads;
    EXPECT_EQ(levels.atCorners, expected.atCorners) << threads;
  }
}
