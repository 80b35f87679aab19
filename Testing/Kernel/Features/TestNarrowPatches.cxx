// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/NarrowPatches.h"

#include "Features/CarriableFeatures.h"
#include "Features/FoldedStrips.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

constexpr double Length = 4.0;
constexpr double CreaseAngle = 30.0;
using Lines = std::vector<int>;

struct Strips
{
  std::vector<double> widths;
  std::vector<double> folds;
};

/// Which fold lines are left, and what the function said.
struct Outcome
{
  Lines lines;
  bool hasMerged = false;
};

Outcome merged(const Strips& strips, double width, double scale = 1.0, bool isTurned = false)
{
  SurfaceMesh mesh = foldedStrips(strips.widths, strips.folds, Length, 5);
  mesh = transformed(isTurned ? reversed(mesh) : mesh, scale, Vec3::Zero());
  const TargetTriangles target(mesh);
  SharpEdges sharp(target, CreaseAngle, false);
  Outcome outcome;
  outcome.hasMerged = mergeNarrowPatches(target, sharp, scale * width);
  outcome.lines = sharpLines(target, sharp, strips.widths.size());
  return outcome;
}

/// Area over half the border of a strip, or of several that are one.
double widthOf(double strip)
{
  return strip * Length / (strip + Length);
}

/// The rules of keepCarriable() on numbers: patches in a row, each a width and the fold beside it.
Lines mergedByTheRules(Strips strips, double width)
{
  Lines lines(strips.folds.size(), 1);
  std::vector<std::size_t> lineOf(strips.folds.size());
  for (std::size_t k = 0; k < lineOf.size(); ++k)
  {
    lineOf[k] = k;
  }
  while (strips.widths.size() > 1)
  {
    const auto narrowest = std::min_element(strips.widths.begin(), strips.widths.end());
    if (!(widthOf(*narrowest) < width))
    {
      break;
    }
    // The border of a fold's length is the same on both sides: the weaker one goes; of two alike
    // that to the larger neighbour.
    const auto p = static_cast<std::size_t>(narrowest - strips.widths.begin());
    std::size_t fold = p == 0 ? 0 : p - 1;
    if (p > 0 && p + 1 < strips.widths.size())
    {
      const double left = strips.folds[p - 1];
      const double right = strips.folds[p];
      const bool areAlike = std::abs(left - right) <= SimilarFold;
      const bool isRightLarger = strips.widths[p + 1] > (1.0 + SimilarSize) * strips.widths[p - 1];
      fold = (areAlike ? isRightLarger : right < left) ? p : p - 1;
    }
    lines[lineOf[fold]] = 0;
    strips.widths[fold] += strips.widths[fold + 1];
    const auto offset = static_cast<std::ptrdiff_t>(fold);
    strips.widths.erase(strips.widths.begin() + offset + 1);
    strips.folds.erase(strips.folds.begin() + offset);
    lineOf.erase(lineOf.begin() + offset);
  }
  return lines;
}

} // namespace

TEST(NarrowPatches, GoToTheNeighbourBehindTheWeakerFold)
{
  const Outcome left = merged({ { 1.0, 0.1, 1.0 }, { 40.0, 60.0 } }, 0.2);
  EXPECT_TRUE(left.hasMerged);
  EXPECT_EQ(left.lines, (Lines{ 0, 1 }));
  EXPECT_EQ(merged({ { 1.0, 0.1, 1.0 }, { 60.0, 40.0 } }, 0.2).lines, (Lines{ 1, 0 }));
}

TEST(NarrowPatches, AreThoseBelowTheWidth)
{
  const Strips strips{ { 1.0, 0.1, 1.0 }, { 40.0, 60.0 } };
  EXPECT_EQ(merged(strips, 1.001 * widthOf(0.1)).lines, (Lines{ 0, 1 }));
  const Outcome kept = merged(strips, 0.999 * widthOf(0.1));
  EXPECT_FALSE(kept.hasMerged);
  EXPECT_EQ(kept.lines, (Lines{ 1, 1 }));
}

TEST(NarrowPatches, BetweenFoldsAlikeGoToTheLargerNeighbour)
{
  EXPECT_EQ(merged({ { 1.0, 0.1, 2.0 }, { 50.0, 52.0 } }, 0.2).lines, (Lines{ 1, 0 }));
  EXPECT_EQ(merged({ { 2.0, 0.1, 1.0 }, { 52.0, 50.0 } }, 0.2).lines, (Lines{ 0, 1 }));
  // Of neighbours alike, too, the one with the smallest triangle.
  EXPECT_EQ(merged({ { 1.0, 0.1, 1.05 }, { 52.0, 50.0 } }, 0.2).lines, (Lines{ 0, 1 }));
}

TEST(NarrowPatches, AreMergedUntilNoneIsNarrow)
{
  // Nine strips of 0.1 are one of 0.9: the last fold stays, or the whole is wide enough.
  const std::vector<double> folds(8, 45.0);
  const Outcome all = merged({ std::vector<double>(9, 0.1), folds }, 2.0);
  EXPECT_EQ(all.lines, Lines(8, 0));
  const Outcome some = merged({ std::vector<double>(9, 0.1), folds }, 0.15);
  EXPECT_GT(std::count(some.lines.begin(), some.lines.end(), 1), 1);
  EXPECT_LT(std::count(some.lines.begin(), some.lines.end(), 1), 5);
}

TEST(NarrowPatches, FollowTheRulesOnAnyStrips)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> width(0.05, 0.6);
  std::uniform_real_distribution<double> fold(31.0, 80.0);
  for (int trial = 0; trial < 100; ++trial)
  {
    Strips strips;
    const int count = 2 + trial % 7;
    for (int k = 0; k < count; ++k)
    {
      strips.widths.push_back(width(random));
    }
    for (int k = 0; k + 1 < count; ++k)
    {
      strips.folds.push_back(fold(random));
    }
    for (const double least : { 0.1, 0.2, 0.4 })
    {
      const Outcome outcome = merged(strips, least);
      const Lines expected = mergedByTheRules(strips, least);
      ASSERT_EQ(outcome.lines, expected) << trial << ' ' << least;
      ASSERT_EQ(outcome.hasMerged, std::count(expected.begin(), expected.end(), 0) > 0);
    }
  }
}

TEST(NarrowPatches, DoNotDependOnUnitsOrSides)
{
  const Strips strips{ { 0.3, 0.1, 0.5, 0.05, 0.2 }, { 40.0, 60.0, 50.0, 35.0 } };
  const Lines expected = merged(strips, 0.2).lines;
  for (const double scale : { 0x1p-30, 1e-3, 1e6 })
  {
    EXPECT_EQ(merged(strips, 0.2, scale).lines, expected) << scale;
    EXPECT_EQ(merged(strips, 0.2, scale, true).lines, expected) << scale;
  }
}

TEST(NarrowPatches, WithoutANeighbourStay)
{
  const TargetTriangles target(sphere(2));
  SharpEdges sharp(target, 90.0, false);
  EXPECT_FALSE(mergeNarrowPatches(target, sharp, std::numeric_limits<double>::infinity()));
}
