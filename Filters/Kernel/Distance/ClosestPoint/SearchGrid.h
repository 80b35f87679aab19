// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The grid that a search for closest triangles fills, and its blocks.
 */

#ifndef EVOLVING_SEARCH_GRID_H
#define EVOLVING_SEARCH_GRID_H

#include "Distance/DistanceGrid.h"
#include "Mesh/SurfaceMesh.h"
#include "Trees/TriangleGeometry.h"
#include "Types.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace evolving
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

} // namespace evolving

#endif
