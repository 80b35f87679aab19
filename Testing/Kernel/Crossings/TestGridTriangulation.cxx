// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/GridTriangulation.h"

#include "Crossings/SegmentInsertion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

using namespace evolving;

namespace
{

constexpr std::int64_t Unit = GridPoint::Unit;

/// A triangulation that remembers where its vertices are.
struct Checked
{
  GridTriangulation cells;
  std::vector<GridPoint> points = { { 0, 0 }, { Unit, 0 }, { 0, Unit } };

  Index insert(const GridPoint& point)
  {
    const Index vertex = this->cells.insert(point);
    if (vertex == static_cast<Index>(this->points.size()))
    {
      this->points.push_back(point);
    }
    return vertex;
  }

  bool hasEdge(Index a, Index b) const
  {
    for (Index c = 0; c < this->cells.cellCount(); ++c)
    {
      const auto& v = this->cells.cell(c);
      if (std::count(v.begin(), v.end(), a) == 1 && std::count(v.begin(), v.end(), b) == 1)
      {
        return true;
      }
    }
    return false;
  }

  std::int64_t doubleArea(Index c) const
  {
    const auto& v = this->cells.cell(c);
    const GridPoint& p = this->points[at(v[0])];
    const GridPoint& q = this->points[at(v[1])];
    const GridPoint& r = this->points[at(v[2])];
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  }

  /// All cells are counter-clockwise, fill the triangle and use every vertex.
  void expectFilled() const
  {
    std::int64_t area = 0;
    std::set<Index> used;
    for (Index c = 0; c < this->cells.cellCount(); ++c)
    {
      EXPECT_GT(this->doubleArea(c), 0);
      area += this->doubleArea(c);
      used.insert(this->cells.cell(c).begin(), this->cells.cell(c).end());
    }
    EXPECT_EQ(area, Unit * Unit);
    EXPECT_EQ(used.size(), this->points.size());
  }
};

GridPoint randomGridPoint(std::mt19937& generator, std::int64_t step)
{
  std::uniform_int_distribution<std::int64_t> number(0, Unit / step);
  const std::int64_t x = number(generator) * step;
  const std::int64_t y = number(generator) * step;
  return x + y <= Unit ? GridPoint{ x, y } : GridPoint{ Unit - x, Unit - y };
}

/// Whether the segments have a point in common that is inside of both.
bool cross(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
  return gridOrientation(a, b, c) * gridOrientation(a, b, d) < 0 &&
    gridOrientation(c, d, a) * gridOrientation(c, d, b) < 0;
}

} // namespace

TEST(GridTriangulation, FillsTheTriangleAroundPointsAnywhere)
{
  // Coarse steps put many points on one another, on sides and on lines.
  for (const std::int64_t step : { std::int64_t(1), Unit / 1024, Unit / 16, Unit / 4 })
  {
    std::mt19937 generator(7);
    Checked checked;
    for (int i = 0; i < 200; ++i)
    {
      checked.insert(randomGridPoint(generator, step));
    }
    checked.expectFilled();
  }
}

TEST(GridTriangulation, IsDelaunays)
{
  std::mt19937 generator(3);
  Checked checked;
  for (int i = 0; i < 60; ++i)
  {
    checked.insert(randomGridPoint(generator, Unit / 4096));
  }
  for (Index c = 0; c < checked.cells.cellCount(); ++c)
  {
    for (const GridPoint& point : checked.points)
    {
      Eigen::Matrix3d rows;
      for (Eigen::Index k = 0; k < 3; ++k)
      {
        const GridPoint& corner =
          checked.points[at(checked.cells.cell(c)[static_cast<std::size_t>(k)])];
        const double x = static_cast<double>(corner.x - point.x) / static_cast<double>(Unit);
        const double y = static_cast<double>(corner.y - point.y) / static_cast<double>(Unit);
        rows.row(k) << x, y, x * x + y * y;
      }
      EXPECT_LE(rows.determinant(), 1e-12);
    }
  }
}

TEST(GridTriangulation, GivesAPointThatIsThereItsVertex)
{
  Checked checked;
  EXPECT_EQ(checked.insert({ Unit, 0 }), 1);
  const Index vertex = checked.insert({ 5, 7 });
  EXPECT_EQ(vertex, 3);
  checked.insert({ 4, 9 });
  EXPECT_EQ(checked.insert({ 5, 7 }), vertex);
  EXPECT_EQ(checked.cells.vertexCount(), 5);
}

TEST(SegmentInsertion, MakesEdgesAndKeepsThem)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    std::mt19937 generator(seed);
    Checked checked;
    for (int i = 0; i < 50; ++i)
    {
      checked.insert(randomGridPoint(generator, Unit / 8192));
    }
    std::uniform_int_distribution<Index> any(0, checked.cells.vertexCount() - 1);
    std::vector<std::pair<Index, Index>> kept;
    for (int i = 0; i < 60; ++i)
    {
      const Index a = any(generator);
      const Index b = any(generator);
      const auto& p = checked.points;
      const bool isFree = a != b &&
        std::none_of(kept.begin(), kept.end(),
          [&](const auto& segment)
          { return cross(p[at(a)], p[at(b)], p[at(segment.first)], p[at(segment.second)]); });
      const bool isOnVertices = std::any_of(p.begin(), p.end(),
        [&](const GridPoint& other)
        { return a != b && gridOrientation(p[at(a)], p[at(b)], other) == 0; });
      const bool isConnected = a != b && insertSegment(checked.cells, a, b);
      if (isFree && (isConnected || !isOnVertices))
      {
        EXPECT_TRUE(isConnected) << a << " " << b << " of seed " << seed;
      }
      if (isConnected && checked.hasEdge(a, b))
      {
        kept.emplace_back(a, b);
      }
    }
    checked.expectFilled();
    EXPECT_GT(kept.size(), 10U);
    for (const auto& [a, b] : kept)
    {
      EXPECT_TRUE(checked.hasEdge(a, b)) << a << " " << b << " of seed " << seed;
    }
  }
}

TEST(SegmentInsertion, GoesThroughTheVerticesOnTheWay)
{
  Checked checked;
  std::vector<Index> line;
  for (std::int64_t i = 1; i <= 5; ++i)
  {
    line.push_back(checked.insert({ i * Unit / 8, Unit / 4 }));
  }
  checked.insert({ Unit / 4, Unit / 8 });
  EXPECT_TRUE(insertSegment(checked.cells, line.front(), line.back()));
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    EXPECT_TRUE(checked.hasEdge(line[i - 1], line[i]));
  }
}

TEST(SegmentInsertion, DoesNotCrossAnotherSegment)
{
  Checked checked;
  const Index a = checked.insert({ Unit / 8, Unit / 8 });
  const Index b = checked.insert({ Unit / 4, Unit / 4 });
  const Index c = checked.insert({ Unit / 8, Unit / 4 });
  const Index d = checked.insert({ Unit / 4, Unit / 8 });
  EXPECT_TRUE(insertSegment(checked.cells, a, b));
  EXPECT_FALSE(insertSegment(checked.cells, c, d));
  EXPECT_TRUE(checked.hasEdge(a, b));
  EXPECT_FALSE(checked.hasEdge(c, d));
  checked.expectFilled();
}
