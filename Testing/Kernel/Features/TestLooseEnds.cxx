// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/LooseEnds.h"

#include "Features/TargetTriangles.h"
#include "Mesh/Angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace evolving;

namespace
{

constexpr double Sharp = 30.0;

/// Between two strips of squares an edge for each fold, in degrees, along y, but for what the x of
/// their ends differ.
SurfaceMesh foldedBy(const std::vector<double>& folds, const std::vector<double>& x)
{
  SurfaceMesh mesh;
  for (std::size_t row = 0; row <= folds.size(); ++row)
  {
    const Vec3 end(row < x.size() ? x[row] : 0.0, static_cast<double>(row), 0.0);
    mesh.addPoint(end - Vec3::UnitX());
    mesh.addPoint(end);
  }
  for (std::size_t row = 0; row < folds.size(); ++row)
  {
    // The right strip of each row has points of its own, turned down about y.
    const double fold = folds[row] * RadiansPerDegree;
    const Vec3 down(std::cos(fold), 0.0, -std::sin(fold));
    const auto first = static_cast<Index>(2 * row);
    const Index right = mesh.addPoint(mesh.points[at(first + 1)] + down);
    const Index above = mesh.addPoint(mesh.points[at(first + 3)] + down);
    mesh.addFace({ first, first + 1, first + 3 });
    mesh.addFace({ first, first + 3, first + 2 });
    mesh.addFace({ first + 1, right, above });
    mesh.addFace({ first + 1, above, first + 3 });
  }
  return mesh;
}

using Flags = std::vector<bool>;

/// Of each of these edges: is it sharp in the end?
Flags followed(const std::vector<double>& folds, double weakest, const std::vector<double>& x = {})
{
  const SurfaceMesh mesh = foldedBy(folds, x);
  const TargetTriangles target(mesh);
  SharpEdges sharp(target, Sharp, false);
  followLooseEnds(target, sharp, weakest);
  Flags isSharp(folds.size(), false);
  for (const Index edge : sharp.list())
  {
    const auto [a, b] = target.edgeVertices(edge);
    EXPECT_EQ(std::abs(target.point(a).y() - target.point(b).y()), 1.0);
    isSharp[static_cast<std::size_t>(std::min(target.point(a).y(), target.point(b).y()))] = true;
  }
  return isSharp;
}

} // namespace

TEST(LooseEnds, AreJoinedOverWeakerFolds)
{
  EXPECT_EQ(followed({ 40, 40, 20, 15, 20, 40 }, 10.0), Flags(6, true));
  EXPECT_EQ(followed({ 40, 20, 40, 20, 40 }, 10.0), Flags(5, true));
}

TEST(LooseEnds, StayWhereFoldsAreTooWeak)
{
  EXPECT_EQ(followed({ 40, 20, 15, 20, 40 }, 16.0), (Flags{ true, false, false, false, true }));
}

TEST(LooseEnds, StayWhereNothingIsBehindThem)
{
  EXPECT_EQ(followed({ 40, 40, 20, 20, 20 }, 10.0), (Flags{ true, true, false, false, false }));
}

TEST(LooseEnds, AreNotFollowedForEver)
{
  std::vector<double> folds(23, 20.0);
  folds.front() = 40.0;
  folds.back() = 40.0;
  Flags ends(23, false);
  ends.front() = true;
  ends.back() = true;
  EXPECT_EQ(followed(folds, 10.0), ends);
  folds.erase(folds.begin() + 1); // 20 between them
  EXPECT_EQ(followed(folds, 10.0), Flags(22, true));
}

TEST(LooseEnds, AreFollowedAroundBluntTurnsOnly)
{
  // The second of three edges runs askew, by 56 and by 66 degrees, which makes it fold by 18.
  EXPECT_EQ(followed({ 40, 10, 40 }, 10.0, { 0.0, 0.0, 1.5, 1.5 }), Flags(3, true));
  EXPECT_EQ(followed({ 40, 8, 40 }, 10.0, { 0.0, 0.0, 2.2, 2.2 }), (Flags{ true, false, true }));
}
