// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoint/ClosestOnGrid.h"

#include "Distance/ClosestPoint/OrientedBoxTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

/// The samples to be filled, in units of the grid's longest spacing from its sample (0, 0, 0).
struct SearchGrid
{
  static constexpr int BlockSide = 16;
  static constexpr float Near = 1.5F; ///< distances below are computed again, in double

  SearchGrid(const SurfaceMesh& mesh, const DistanceGrid& distanceGrid, double rounding, double far)
    : Mesh(mesh)
    , Grid(distanceGrid)
    , margin(static_cast<float>(rounding))
    , band(static_cast<float>(far / distanceGrid.spacing.maxCoeff()))
    , unit(static_cast<float>(distanceGrid.spacing.maxCoeff()))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->step[axis] = distanceGrid.spacing[axis] / distanceGrid.spacing.maxCoeff();
    }
  }

  /// Has the grid a sample of a block?
  bool meets(const int corner[3], int side) const
  {
    const Extent& e = this->Grid.extent;
    return corner[0] + side > e[0] && corner[0] <= e[1] && corner[1] + side > e[2] &&
      corner[1] <= e[3] && corner[2] + side > e[4] && corner[2] <= e[5];
  }

  /// Samples side by side along x: the first one's number in the grid and place in the block.
  struct Row
  {
    GridIndex first;
    int count;
    int i;
    int j;
    int k;
  };

  /// Visits the rows of a block as far as they are in the grid.
  template <typename Visit>
  void forEachRowOf(const int corner[3], int side, const Visit& visit) const
  {
    const Extent& e = this->Grid.extent;
    int first[3];
    int end[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      first[axis] = std::max(0, e[2 * axis] - corner[axis]);
      end[axis] = std::min(side, e[2 * axis + 1] - corner[axis] + 1);
    }
    for (int k = first[2]; k < end[2]; ++k)
    {
      for (int j = first[1]; j < end[1]; ++j)
      {
        const GridIndex start =
          this->Grid.index(corner[0] + first[0], corner[1] + j, corner[2] + k);
        visit(Row{ start, end[0] - first[0], first[0], j, k });
      }
    }
  }

  /// From sample number `place` of a brick.
  float exactDistance(const int corner[3], int place, Index face) const
  {
    const Vec3 point = this->Grid.point(
      corner[0] + (place & 3), corner[1] + (place >> 2 & 3), corner[2] + (place >> 4));
    const double squared =
      closestPointOnTriangle(point, triangleOf(this->Mesh, face)).squaredDistance;
    return static_cast<float>(std::sqrt(squared));
  }

private:
  const SurfaceMesh& Mesh;
  const DistanceGrid& Grid;

public:
  double step[3]; ///< between samples, at most 1
  float margin;   ///< above the rounding of places to floats
  float band;     ///< samples farther away may be left out
  float unit;     ///< in the grid's unit
};

// The search is compiled once for any processor and, where the compiler can, once more for those
// with AVX2.
#define EVOLVING_LANES_HAVE_AVX 0
namespace anywhere
{
#include "Distance/ClosestPoint/Lanes.hxx"

#include "Distance/ClosestPoint/BlockSearch.hxx"
}

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define EVOLVING_HAS_AVX2_SEARCH
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#undef EVOLVING_LANES_HAVE_AVX
#define EVOLVING_LANES_HAVE_AVX 1
namespace avx2
{
#include "Distance/ClosestPoint/Lanes.hxx"

#include "Distance/ClosestPoint/BlockSearch.hxx"
}
#pragma GCC pop_options
#endif

double longestSpacing(const DistanceGrid& grid)
{
  return grid.spacing.maxCoeff();
}

/// The largest coordinate of the mesh and the grid in the search's unit.
double largestCoordinate(const SurfaceMesh& mesh, const DistanceGrid& grid)
{
  const Extent& e = grid.extent;
  Box box(grid.point(e[0], e[2], e[4]));
  box.extend(grid.point(e[1], e[3], e[5]));
  box.extend(boundingBox(mesh));
  const Vec3 reach =
    (box.max() - grid.origin).cwiseAbs().cwiseMax((box.min() - grid.origin).cwiseAbs());
  return reach.maxCoeff() / longestSpacing(grid);
}

std::vector<Triangle> trianglesInCells(const SurfaceMesh& mesh, const DistanceGrid& grid)
{
  const double unit = longestSpacing(grid);
  std::vector<Triangle> triangles = trianglesOf(mesh);
  for (Triangle& triangle : triangles)
  {
    for (Vec3& corner : triangle.corners)
    {
      corner = (corner - grid.origin) / unit;
    }
  }
  return triangles;
}

/// The blocks that a grid meets, numbered along x, y, z.
class Blocks
{
public:
  explicit Blocks(const Extent& extent)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      // Extents may begin below zero; blocks begin at multiples of their side all the same.
      this->First[axis] = floorDivided(extent[2 * axis]);
      this->Count[axis] = floorDivided(extent[2 * axis + 1]) - this->First[axis] + 1;
    }
  }
  std::int64_t count() const
  {
    return std::int64_t(this->Count[0]) * this->Count[1] * this->Count[2];
  }
  std::array<int, 3> corner(std::int64_t number) const
  {
    std::array<int, 3> place{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      place[axis] =
        SearchGrid::BlockSide * (this->First[axis] + static_cast<int>(number % this->Count[axis]));
      number /= this->Count[axis];
    }
    return place;
  }

private:
  static int floorDivided(int sample)
  {
    const int side = SearchGrid::BlockSide;
    return sample >= 0 ? sample / side : -((side - 1 - sample) / side);
  }

  std::array<int, 3> First{};
  std::array<int, 3> Count{};
};

template <typename Search>
void searchBlocks(const OrientedBoxTree& tree, const SearchGrid& grid, const Extent& extent,
  const Execution& execution, GridClosest& result)
{
  const Blocks blocks(extent);
  constexpr std::int64_t BlockGrain = 4; // a few milliseconds
  execution.forRangeReporting(blocks.count(), BlockGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      Search search(tree, grid, result);
      for (std::int64_t block = begin; block < end; ++block)
      {
        search.search(blocks.corner(block).data());
      }
    });
}

} // namespace

bool isWithinReachOfFloats(const SurfaceMesh& mesh, const DistanceGrid& grid)
{
  constexpr double Many = 1e6; // the margin would be a cell
  return largestCoordinate(mesh, grid) < Many;
}

GridClosest closestOnGrid(const SurfaceMesh& mesh, const DistanceGrid& grid, double band,
  const Execution& execution, Instructions instructions)
{
  constexpr double Rounding = 1e-6; // some units in the last place of the largest coordinate
  const double margin = Rounding * (1.0 + largestCoordinate(mesh, grid));
  const OrientedBoxTree tree(trianglesInCells(mesh, grid), margin, execution.phase(0.0, 0.1));
  const SearchGrid search(mesh, grid, margin, band);
  GridClosest result;
  result.distance.resize(static_cast<std::size_t>(grid.sampleCount()));
  result.triangle.resize(static_cast<std::size_t>(grid.sampleCount()));
  const Execution searching = execution.phase(0.1, 1.0);
#if defined(EVOLVING_HAS_AVX2_SEARCH)
  if (instructions == Instructions::Best && __builtin_cpu_supports("avx2") &&
    __builtin_cpu_supports("fma"))
  {
    searchBlocks<avx2::BlockSearch>(tree, search, grid.extent, searching, result);
  }
  else
#endif
  {
    static_cast<void>(instructions);
    searchBlocks<anywhere::BlockSearch>(tree, search, grid.extent, searching, result);
  }
  return result;
}

} // namespace evolving
