// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/WindingSign.h"

#include "Distance/Signs/WindingNumber.h"
#include "Mesh/Angles.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace evolving
{

namespace
{

/// The cells of a grid that middles of short pieces of the open edges are in, as points: of
/// thousands of edges in one cell one point.
SurfaceMesh cellsOfOpenEdges(const DistanceTarget& target, double cell)
{
  std::set<std::array<double, 3>> cells;
  for (const auto& [from, to] : target.orientation.openEdges)
  {
    const Vec3& start = target.mesh.points[at(from)];
    const Vec3 way = target.mesh.points[at(to)] - start;
    const double pieces = std::ceil(way.norm() / cell);
    for (double piece = 0.5; piece < pieces; piece += 1.0)
    {
      const Vec3 place = (start + piece / pieces * way) / cell;
      cells.insert({ std::floor(place.x()), std::floor(place.y()), std::floor(place.z()) });
    }
  }
  SurfaceMesh points;
  for (const auto& [x, y, z] : cells)
  {
    const Index point = points.addPoint(cell * Vec3(x + 0.5, y + 0.5, z + 0.5));
    points.addFace({ point, point, point });
  }
  return points;
}

/// A step between samples, but of a model far larger than the grid's part of it not too many.
double cellOfOpenEdges(const DistanceTarget& target, const DistanceGrid& grid)
{
  constexpr double MostPieces = 100000.0;
  return std::max(grid.spacing.maxCoeff(), target.orientation.openLength / MostPieces);
}

/// How fast the winding number can change between crossings of the surface.
class OpenEdges
{
public:
  /// @param cell which distances may fall short by, and half of it
  OpenEdges(const DistanceTarget& target, double cell)
    : Tree(cellsOfOpenEdges(target, cell))
    , Slack((0.5 * std::sqrt(3.0) + 0.5) * cell) // half a cell's diagonal, and half a piece
    , Strength(target.orientation.openLength / (4.0 * Pi))
  {
  }

  /// A lower bound.
  double distance(const Vec3& point) const
  {
    return this->Tree.isEmpty()
      ? std::numeric_limits<double>::infinity()
      : std::sqrt(this->Tree.closest(point).at.squaredDistance) - this->Slack;
  }
  /// Per unit of way, at a distance.
  double largestChange(double distance) const { return this->Strength / (distance * distance); }

private:
  AABBTree Tree;
  double Slack;
  double Strength;
};

/// Samples nearer to the surface, in steps between samples, may be on either side of it.
constexpr double OnSurface = 1e-6;

/// By how much the crossings of the surface change the winding number along a line of samples.
class Crossings
{
public:
  /**
   * The ray runs beside the line, nearer than what is told apart: planes and edges of a model often
   * lie where samples do, and no ray tells the sides of a plane that it runs in.
   * @param step from one sample of the line to the next
   */
  Crossings(const AABBTree& surface, const Vec3& first, const Vec3& step)
    : Hits(surface.hits(Ray(first + OnSurface * step.norm() * Vec3(0.31, 0.27, 0.22), step)))
  {
  }

  /// By those between the sample asked for last, at first the line's first, and this one.
  int changeUpTo(int sample)
  {
    int change = 0;
    for (; this->Next < this->Hits.size() && this->Hits[this->Next].parameter <= sample;
         ++this->Next)
    {
      change += this->Hits[this->Next].isFromBehind ? -1 : 1;
    }
    return change;
  }

private:
  std::vector<RayHit> Hits;
  std::size_t Next = 0;
};

/// What every walk over samples needs.
struct WindingField
{
  WindingNumber number;
  OpenEdges edges;
  AABBTree surface;
};

/// Carries the winding number of one sample on to the next as long as that tells the side.
class WindingWalk
{
public:
  explicit WindingWalk(const WindingField& field)
    : Field(&field)
  {
  }

  /**
   * @param clearance at the point, a lower bound
   * @param step the way to the point
   * @param change of the winding number by crossings on this way
   */
  bool isInside(const Vec3& point, double clearance, double step, int change)
  {
    constexpr double Rounding = 1.0 + 1e-6;
    const double gap = 0.5 * (this->LastClearance + clearance - Rounding * step);
    const bool isClear = std::min(this->LastClearance, clearance) > OnSurface * step;
    this->LastClearance = clearance;
    this->Winding += change;
    this->ToEdges -= step;
    if (this->ToEdges < std::max(gap, 0.5 * this->ToEdgesWhenMeasured))
    {
      // On the way here it was no less than at its ends less the step.
      this->ToEdges = this->ToEdgesWhenMeasured = this->Field->edges.distance(point) - step;
    }
    const double toEdges = std::max(gap, this->ToEdges);
    this->Drift += isClear && toEdges > 0.0 ? step * this->Field->edges.largestChange(toEdges)
                                            : std::numeric_limits<double>::infinity();
    // Twice the tolerance: what was evaluated, and what would be here.
    const double doubt = 2.0 * WindingNumber::Tolerance + this->Drift;
    if (!(std::abs(this->Winding - WindingThreshold) > doubt))
    {
      this->Winding = this->Field->number.at(point);
      this->Drift = 0.0;
    }
    return this->Winding > WindingThreshold;
  }

private:
  const WindingField* Field;
  double LastClearance = 0.0;
  double ToEdges = 0.0; ///< a lower bound for the distance
  double ToEdgesWhenMeasured = 0.0;
  double Winding = 0.0; ///< of the last sample
  double Drift = 0.0;   ///< what it may be off by
};

/// Rows of samples, the first sample of each reached from the one before.
class RowsInside
{
public:
  RowsInside(const WindingField& field, const DistanceGrid& grid,
    const std::vector<float>& clearance, std::vector<char>& inside)
    : Field(field)
    , Grid(grid)
    , Clearance(clearance)
    , Inside(inside)
  {
  }

  /// Rows [begin, end), numbered along y, z.
  void fill(std::int64_t begin, std::int64_t end) const
  {
    const int height = this->Grid.dimension(1);
    while (begin < end)
    {
      const auto k = static_cast<int>(begin / height);
      const auto j = static_cast<int>(begin % height);
      const int count = static_cast<int>(std::min<std::int64_t>(end - begin, height - j));
      this->fillSlice(k, j, count);
      begin += count;
    }
  }

private:
  Vec3 point(int i, int j, int k) const
  {
    const Extent& e = this->Grid.extent;
    return this->Grid.point(e[0] + i, e[2] + j, e[4] + k);
  }
  void step(WindingWalk& walk, const Vec3& to, std::size_t sample, double length, int change) const
  {
    const auto clearance = static_cast<double>(this->Clearance[sample]);
    this->Inside[sample] = walk.isInside(to, clearance, length, change);
  }

  /// Rows of one z.
  void fillSlice(int k, int firstRow, int count) const
  {
    const Vec3& spacing = this->Grid.spacing;
    const auto width = static_cast<std::size_t>(this->Grid.dimension(0));
    const Vec3 first = this->point(0, firstRow, k);
    Crossings betweenRows(this->Field.surface, first, spacing.y() * Vec3::UnitY());
    WindingWalk upwards(this->Field);
    for (int row = 0; row < count; ++row)
    {
      const int j = firstRow + row;
      const std::size_t sample = (at(k) * at(this->Grid.dimension(1)) + at(j)) * width;
      const Vec3 start = this->point(0, j, k);
      this->step(upwards, start, sample, spacing.y(), betweenRows.changeUpTo(row));
      Crossings crossings(this->Field.surface, start, spacing.x() * Vec3::UnitX());
      crossings.changeUpTo(0);
      WindingWalk along = upwards;
      for (int i = 1; i < this->Grid.dimension(0); ++i)
      {
        this->step(
          along, this->point(i, j, k), sample + at(i), spacing.x(), crossings.changeUpTo(i));
      }
    }
  }

  const WindingField& Field;
  const DistanceGrid& Grid;
  const std::vector<float>& Clearance;
  std::vector<char>& Inside;
};

} // namespace

std::vector<char> insideByWindingNumber(const DistanceTarget& target, const DistanceGrid& grid,
  const std::vector<float>& clearance, const Execution& execution)
{
  const WindingField field{ WindingNumber(trianglesOf(target.mesh), execution.phase(0.0, 0.2)),
    OpenEdges(target, cellOfOpenEdges(target, grid)),
    AABBTree(target.mesh, execution.phase(0.2, 0.3)) };
  std::vector<char> inside(clearance.size(), 0);
  const RowsInside rows(field, grid, clearance, inside);
  constexpr std::int64_t RowGrain = 16;
  execution.phase(0.3, 1.0).forRangeReporting(std::int64_t(grid.dimension(1)) * grid.dimension(2),
    RowGrain, [&](std::int64_t begin, std::int64_t end) { rows.fill(begin, end); });
  return inside;
}

} // namespace evolving
