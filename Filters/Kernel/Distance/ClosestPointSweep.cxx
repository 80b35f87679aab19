// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPointSweep.h"

#include "Distance/ClosestTriangles.h"
#include "Distance/MeasuredTriangle.h"
#include "Distance/RowSweep.h"
#include "Distance/SurfaceBand.h"
#include "Distance/TriangleNeighbours.h"

#include <array>
#include <cmath>

namespace evolving
{

namespace
{

/// How far from the surface samples are exact from the start, in cells.
constexpr double BandReach = 1.0;

class ClosestPointSweep
{
public:
  ClosestPointSweep(const AABBTree& tree, const DistanceGrid& grid)
    : Cell(grid.spacing.maxCoeff())
    , NearestOf(static_cast<std::size_t>(grid.sampleCount()))
  {
    this->Grid.dimensions = { grid.dimension(0), grid.dimension(1), grid.dimension(2) };
    this->Grid.spacing = grid.spacing / this->Cell;
    this->Center = grid.point(grid.extent[0], grid.extent[2], grid.extent[4]);
    this->Triangles.reserve(tree.triangles().size());
    this->Boxes.reserve(tree.triangles().size());
    for (const Triangle& triangle : tree.triangles())
    {
      Triangle scaled = triangle;
      for (Vec3& corner : scaled.corners)
      {
        corner = (corner - this->Center) / this->Cell;
      }
      this->Triangles.emplace_back(scaled);
      this->Boxes.push_back(scaled.box());
    }
  }

  void drawBand(const Execution& execution)
  {
    drawSurfaceBand(
      this->Triangles, this->Boxes, this->Grid, BandReach, this->NearestOf, execution);
  }

  /// Gives samples the triangles known for them.
  void seed(const std::vector<Index>& triangles)
  {
    for (std::size_t s = 0; s < triangles.size(); ++s)
    {
      if (triangles[s] != NoIndex)
      {
        const auto sample = static_cast<GridIndex>(s);
        const auto width = this->Grid.dimensions[0];
        const auto row = sample / width;
        this->tryTriangle(this->NearestOf[s], triangles[s],
          this->Grid.point(static_cast<int>(sample % width),
            static_cast<int>(row % this->Grid.dimensions[1]),
            static_cast<int>(row / this->Grid.dimensions[1])));
      }
    }
  }

  void propagate(const Execution& execution)
  {
    constexpr std::array<SweepDirection, 4> Order{ { { true, true }, { false, true },
      { false, false }, { true, false } } };
    for (std::size_t n = 0; n < Order.size(); ++n)
    {
      const auto from = static_cast<double>(n) / static_cast<double>(Order.size());
      const auto to = static_cast<double>(n + 1) / static_cast<double>(Order.size());
      visitRowsInOrder(this->Grid.dimensions[1], this->Grid.dimensions[2], Order[n],
        execution.phase(from, to), [&](int j, int k) { this->visitRow(j, k, Order[n]); });
    }
  }

  /// Every sample walks over the mesh to a closer triangle, while there is one.
  void descend(const SurfaceMesh& mesh, const Execution& execution)
  {
    const TriangleNeighbours neighbours(mesh);
    this->forEachRow(execution,
      [&](int j, int k)
      {
        Nearest* row = this->row(j, k);
        for (int i = 0; i < this->Grid.dimensions[0]; ++i)
        {
          if (!this->isSettled(row[i]))
          {
            this->walk(row[i], this->Grid.point(i, j, k), neighbours);
          }
        }
      });
  }

  /// Every sample tries the triangles of the 26 around it, as they were before, so that order is
  /// no matter.
  std::vector<Index> refined(const Execution& execution) const
  {
    std::vector<Index> result(this->NearestOf.size());
    this->forEachRow(execution, [&](int j, int k) { this->refineRow(j, k, result); });
    return result;
  }

private:
  /// Takes the triangle if it is closer than the sample's.
  void tryTriangle(Nearest& sample, Index triangle, const Vec3& point) const
  {
    const double squared =
      this->Triangles[static_cast<std::size_t>(triangle)].squaredDistance(point);
    const auto distance = static_cast<float>(std::sqrt(squared));
    if (distance < sample.distance)
    {
      sample = { distance, triangle };
    }
  }

  /// Takes the neighbour's triangle if it is closer. @param step between the two samples
  void tryNeighbour(Nearest& sample, const Nearest& neighbour, const Vec3& point, float step) const
  {
    const bool hopeless = neighbour.triangle == NoIndex || neighbour.triangle == sample.triangle ||
      neighbour.distance >= sample.distance + step;
    if (!hopeless)
    {
      this->tryTriangle(sample, neighbour.triangle, point);
    }
  }

  bool isSettled(const Nearest& sample) const { return sample.distance <= float(BandReach); }

  bool hasRow(int j, int k) const
  {
    return j >= 0 && j < this->Grid.dimensions[1] && k >= 0 && k < this->Grid.dimensions[2];
  }

  void visitRow(int j, int k, const SweepDirection& direction)
  {
    const int width = this->Grid.dimensions[0];
    const int beforeJ = direction.yUp ? j - 1 : j + 1;
    const int beforeK = direction.zUp ? k - 1 : k + 1;
    Nearest* row = this->row(j, k);
    this->takeFromRow(row, j, k, beforeJ, k, 0);
    this->takeFromRow(row, j, k, j, beforeK, 0);
    this->takeFromRow(row, j, k, beforeJ, beforeK, 0);
    const auto step = static_cast<float>(this->Grid.spacing.x());
    for (int i = 1; i < width; ++i)
    {
      this->takeOver(row[i], row[i - 1], i, j, k, step);
    }
    for (int i = width - 2; i >= 0; --i)
    {
      this->takeOver(row[i], row[i + 1], i, j, k, step);
    }
  }

  void takeOver(Nearest& sample, const Nearest& neighbour, int i, int j, int k, float step) const
  {
    if (!this->isSettled(sample))
    {
      this->tryNeighbour(sample, neighbour, this->Grid.point(i, j, k), step);
    }
  }

  /// @param shift along x from a sample to the one it takes from
  void takeFromRow(Nearest* row, int j, int k, int otherJ, int otherK, int shift) const
  {
    if (!this->hasRow(otherJ, otherK))
    {
      return;
    }
    const Nearest* other = this->row(otherJ, otherK);
    const auto step = static_cast<float>(
      (this->Grid.point(0, j, k) - this->Grid.point(shift, otherJ, otherK)).norm());
    const int end = this->Grid.dimensions[0] - std::max(shift, 0);
    for (int i = std::max(-shift, 0); i < end; ++i)
    {
      this->takeOver(row[i], other[i + shift], i, j, k, step);
    }
  }

  void walk(Nearest& sample, const Vec3& point, const TriangleNeighbours& neighbours) const
  {
    Index from = NoIndex;
    while (sample.triangle != from)
    {
      from = sample.triangle;
      for (const Index* next = neighbours.begin(from); next != neighbours.end(from); ++next)
      {
        this->tryTriangle(sample, *next, point);
      }
    }
  }

  void refineRow(int j, int k, std::vector<Index>& result) const
  {
    const int width = this->Grid.dimensions[0];
    std::vector<Nearest> row(this->row(j, k), this->row(j, k) + width);
    for (int otherK = k - 1; otherK <= k + 1; ++otherK)
    {
      for (int otherJ = j - 1; otherJ <= j + 1; ++otherJ)
      {
        for (int shift = -1; shift <= 1; ++shift)
        {
          this->takeFromRow(row.data(), j, k, otherJ, otherK, shift);
        }
      }
    }
    for (int i = 0; i < width; ++i)
    {
      result[static_cast<std::size_t>(this->Grid.index(i, j, k))] =
        row[static_cast<std::size_t>(i)].triangle;
    }
  }

  template <typename Visit>
  void forEachRow(const Execution& execution, const Visit& visit) const
  {
    const int rows = this->Grid.dimensions[1];
    constexpr std::int64_t RowGrain = 16;
    execution.forRangeReporting(std::int64_t(rows) * this->Grid.dimensions[2], RowGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t row = begin; row < end; ++row)
        {
          visit(static_cast<int>(row % rows), static_cast<int>(row / rows));
        }
      });
  }

  Nearest* row(int j, int k) { return this->NearestOf.data() + this->Grid.index(0, j, k); }
  const Nearest* row(int j, int k) const
  {
    return this->NearestOf.data() + this->Grid.index(0, j, k);
  }

  double Cell;
  Vec3 Center = Vec3::Zero();
  UnitGrid Grid;
  std::vector<MeasuredTriangle> Triangles;
  std::vector<Box> Boxes;
  std::vector<Nearest> NearestOf;
};

} // namespace

std::vector<Index> sweepClosestTriangles(const SurfaceMesh& mesh, const AABBTree& tree,
  const DistanceGrid& grid, const Execution& execution)
{
  ClosestPointSweep sweep(tree, grid);
  sweep.drawBand(execution.phase(0.0, 0.2));
  if (!containsAll(grid, tree))
  {
    sweep.seed(queryBoundaryTriangles(tree, grid, execution.phase(0.2, 0.4)));
  }
  sweep.propagate(execution.phase(0.4, 0.7));
  sweep.descend(mesh, execution.phase(0.7, 0.85));
  return sweep.refined(execution.phase(0.85, 1.0));
}

} // namespace evolving
