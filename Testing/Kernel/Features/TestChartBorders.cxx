// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/ChartBorders.h"

#include "Mesh/Angles.h"
#include "Shapes/Sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

using Names = std::vector<Index>;

/// A sheet, its creases, and the names of its triangles.
struct Charts
{
  TargetTriangles target;
  SharpEdges sharp;
  std::vector<char> isFixed;
  Names names;

  explicit Charts(const SurfaceMesh& mesh)
    : target(mesh)
    , sharp(target, 60.0, false)
    , isFixed(static_cast<std::size_t>(target.mesh().faceCount()), 0)
    , names(isFixed.size(), 0)
  {
  }

  Vec3 centroid(Index face) const
  {
    const SurfaceMesh& mesh = this->target.mesh();
    return (mesh.facePoint(face, 0) + mesh.facePoint(face, 1) + mesh.facePoint(face, 2)) / 3.0;
  }

  /// Name 1 where `isRight`, 0 elsewhere; fixed beyond `border` of the sides.
  template <typename IsRight>
  void divide(double left, double right, const IsRight& isRight)
  {
    for (Index face = 0; face < this->target.mesh().faceCount(); ++face)
    {
      const Vec3 p = this->centroid(face);
      this->names[at(face)] = isRight(p) ? 1 : 0;
      this->isFixed[at(face)] = p.x() < left || p.x() > right ? 1 : 0;
    }
  }

  /// What all borders cost by the documentation: length, less nine tenths where it folds most.
  double cost() const
  {
    double cost = 0.0;
    for (Index edge = 0; edge < this->target.edges().edgeCount(); ++edge)
    {
      const Index* c = this->target.edges().begin(edge);
      if (this->target.edges().end(edge) - c == 2 && !this->sharp.isSharp(edge) &&
        this->names[at(c[0] / 3)] != this->names[at(c[1] / 3)])
      {
        cost += this->target.edgeLength(edge) * (1.0 - 0.9 * this->sharp.relativeFold(edge));
      }
    }
    return cost;
  }

  void improve() { improveBorders(this->target, this->sharp, this->isFixed, this->names); }

  double borderLength() const
  {
    double length = 0.0;
    for (const auto& [pair, part] : artificialBorders(this->target, this->sharp, this->names))
    {
      length += part;
    }
    return length;
  }
};

bool isZigzag(const Vec3& p)
{
  return p.x() + 0.2 * std::sin(20.0 * p.y()) > 0.5;
}

} // namespace

TEST(ChartBorders, AreAsLongAsTheEdgesBetweenTwoNames)
{
  Charts charts(sheet(10, true));
  charts.divide(0.0, 1.0, [](const Vec3& p) { return p.x() > 0.5; });
  const BorderLengths borders = artificialBorders(charts.target, charts.sharp, charts.names);
  ASSERT_EQ(borders.size(), 1u);
  EXPECT_EQ(borders.begin()->first, std::make_pair(Index(0), Index(1)));
  EXPECT_NEAR(borders.begin()->second, 1.0, 1e-13);
}

TEST(ChartBorders, DoNotRunAlongCreases)
{
  // A ridge of 90 degrees at x = 0: its edges are sharp, so no part of any border.
  Charts charts(heightField(10, [](double x, double) { return -std::abs(x); }));
  charts.divide(-1.0, 1.0, [](const Vec3& p) { return p.x() > 0.0; });
  EXPECT_TRUE(artificialBorders(charts.target, charts.sharp, charts.names).empty());
}

TEST(ChartBorders, BecomeStraight)
{
  // On a flat sheet the cheapest border from bottom to top is a straight line of length 1.
  Charts charts(sheet(20, true));
  charts.divide(0.05, 0.95, isZigzag);
  EXPECT_GT(charts.borderLength(), 1.5);
  charts.improve();
  EXPECT_NEAR(charts.borderLength(), 1.0, 1e-12);
}

TEST(ChartBorders, GoToWhereTheSurfaceFolds)
{
  // A fold of 40 degrees, too weak for a crease, at x = 0.4: all straight lines are as long.
  const double slope = std::tan(40.0 * Pi / 180.0);
  Charts charts(heightField(20, [&](double x, double) { return -slope * std::max(0.0, x - 0.4); }));
  ASSERT_TRUE(charts.sharp.list().empty());
  charts.divide(-0.85, 0.85, [](const Vec3& p) { return p.x() > -0.3; });
  charts.improve();
  for (Index face = 0; face < charts.target.mesh().faceCount(); ++face)
  {
    EXPECT_EQ(charts.names[at(face)], charts.centroid(face).x() > 0.4 ? 1 : 0) << face;
  }
}

TEST(ChartBorders, AreTheCheapestOfAll)
{
  // Few triangles are free: all ways of naming them are tried.
  std::mt19937 random(9);
  std::uniform_real_distribution<double> height(-0.1, 0.1);
  for (int trial = 0; trial < 20; ++trial)
  {
    Charts charts(heightField(4, [&](double, double) { return height(random); }));
    charts.divide(-2.0, 2.0, [](const Vec3& p) { return p.x() > 0.0; });
    std::vector<Index> free;
    for (Index face = 0; face < charts.target.mesh().faceCount(); ++face)
    {
      const bool isFree = std::abs(charts.centroid(face).x()) < 0.5 && free.size() < 12;
      charts.isFixed[at(face)] = isFree ? 0 : 1;
      if (isFree)
      {
        free.push_back(face);
      }
    }
    Charts other = charts;
    double cheapest = std::numeric_limits<double>::infinity();
    for (unsigned subset = 0; subset < (1u << free.size()); ++subset)
    {
      for (std::size_t k = 0; k < free.size(); ++k)
      {
        other.names[at(free[k])] = static_cast<Index>((subset >> k) & 1u);
      }
      cheapest = std::min(cheapest, other.cost());
    }
    charts.improve();
    EXPECT_NEAR(charts.cost(), cheapest, 1e-12) << trial;
  }
}

TEST(ChartBorders, NeverCostMoreAndNeverTakeFixedTriangles)
{
  std::mt19937 random(10);
  std::uniform_int_distribution<Index> name(0, 3);
  std::uniform_int_distribution<int> die(0, 5);
  std::uniform_real_distribution<double> height(-0.05, 0.05);
  for (int trial = 0; trial < 20; ++trial)
  {
    Charts charts(heightField(10, [&](double, double) { return height(random); }));
    for (std::size_t face = 0; face < charts.names.size(); ++face)
    {
      charts.names[face] = 7 * name(random);
      charts.isFixed[face] = die(random) == 0 ? 1 : 0;
    }
    const Names before = charts.names;
    const double cost = charts.cost();
    charts.improve();
    EXPECT_LT(charts.cost(), cost);
    const std::set<Index> known(before.begin(), before.end());
    for (std::size_t face = 0; face < before.size(); ++face)
    {
      EXPECT_TRUE(charts.isFixed[face] == 0 || charts.names[face] == before[face]);
      EXPECT_EQ(known.count(charts.names[face]), 1u);
    }
    const Names once = charts.names;
    charts.improve();
    EXPECT_LE(charts.cost(),
      [&]
      {
        Charts first = charts;
        first.names = once;
        return first.cost() * (1.0 + 1e-12);
      }());
  }
}

TEST(ChartBorders, DoNotDependOnTheUnit)
{
  const SurfaceMesh mesh =
    heightField(12, [](double x, double y) { return 0.1 * std::sin(3.0 * x + y); });
  Names expected;
  for (const double scale : { 1.0, 0x1p-30, 0x1p30 })
  {
    SurfaceMesh scaled = mesh;
    for (Vec3& p : scaled.points)
    {
      p *= scale;
    }
    Charts charts(scaled);
    charts.divide(-0.9 * scale, 0.9 * scale,
      [&](const Vec3& p) { return isZigzag(0.5 * (p / scale + Vec3::Ones())); });
    charts.improve();
    expected = expected.empty() ? charts.names : expected;
    EXPECT_EQ(charts.names, expected) << scale;
  }
}
