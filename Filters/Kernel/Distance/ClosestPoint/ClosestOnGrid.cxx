// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoint/ClosestOnGrid.h"

#include "Distance/ClosestPoint/OrientedBoxTree.h"
#include "Distance/ClosestPoint/SearchGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

// The search is compiled once for any processor and, where the compiler can, once more for those
// with AVX2.
#define EVOLVING_LANES_HAVE_AVX 0
namespace anywhere
{
#include "Distance/ClosestPoint/Lanes.hxx"

#include "Distance/ClosestPoint/DistanceLanes.hxx"

#include "Distance/ClosestPoint/BrickSearch.hxx"

#include "Distance/ClosestPoint/NearestBox.hxx"

#include "Distance/ClosestPoint/BlockSearch.hxx"
}

#if defined(__GNUC__) && defined(__x86_64__) // and Clang, which says that it is GCC too
#define EVOLVING_HAS_AVX2_SEARCH
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#undef EVOLVING_LANES_HAVE_AVX
#define EVOLVING_LANES_HAVE_AVX 1
namespace avx2
{
#include "Distance/ClosestPoint/Lanes.hxx"

#include "Distance/ClosestPoint/DistanceLanes.hxx"

#include "Distance/ClosestPoint/BrickSearch.hxx"

#include "Distance/ClosestPoint/NearestBox.hxx"

#include "Distance/ClosestPoint/BlockSearch.hxx"
}
#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
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
