// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A triangle cut into smaller ones by points in it.
 */

#ifndef EVOLVING_GRID_TRIANGULATION_H
#define EVOLVING_GRID_TRIANGULATION_H

#include "Crossings/GridPoint.h"
#include "Types.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace evolving
{

///@{
/// The corners of a cell, or the sides opposite to them, in their order.
constexpr std::size_t nextInCell(std::size_t k)
{
  return (k + 1) % 3;
}
constexpr std::size_t previousInCell(std::size_t k)
{
  return (k + 2) % 3;
}
///@}

/**
 * Delaunay's in the grid's coordinates, but for sides that are fixed: points are inserted one by
 * one, with flips (Lawson 1977). Vertices 0, 1 and 2 are the corners.
 */
class GridTriangulation
{
public:
  /// A side of a cell, opposite to its vertex k.
  struct Side
  {
    Index cell = NoIndex;
    std::size_t k = 0;
  };

  GridTriangulation();

  /// @param point in the triangle, its sides included
  /// @return its vertex, an old one where the point is on that
  Index insert(const GridPoint& point);

  Index vertexCount() const { return static_cast<Index>(this->Points.size()); }
  const GridPoint& point(Index vertex) const { return this->Points[at(vertex)]; }
  Index cellCount() const { return static_cast<Index>(this->Cells.size()); }
  /// Its vertices, counter-clockwise.
  const std::array<Index, 3>& cell(Index cell) const { return this->Cells[at(cell)].vertices; }
  /// On which side of the line through two vertices a third is, see gridOrientation().
  int orientation(Index a, Index b, Index c) const;

  /// In any order.
  std::vector<Index> cellsAround(Index vertex) const;
  /// The edge between two vertices, if there is one.
  std::optional<Side> sideBetween(Index a, Index b) const;
  /// The cell across a side, NoIndex at the border.
  Index across(const Side& side) const { return this->Cells[at(side.cell)].across[side.k]; }
  /// The vertex that the cell across a side has besides those of the side.
  Index opposite(const Side& side) const;

  bool isFixed(const Side& side) const { return this->Cells[at(side.cell)].isFixed[side.k]; }
  /// Never flip a side.
  void fix(const Side& side);
  /// May it be flipped: are its two cells convex?
  bool isFlippable(const Side& side) const;
  /// The two cells keep their numbers.
  void flip(const Side& side);

private:
  struct Cell
  {
    std::array<Index, 3> vertices{};
    std::array<Index, 3> across = { NoIndex, NoIndex, NoIndex };
    std::array<bool, 3> isFixed{};
  };
  /// What is beyond a side of a cell.
  struct Beyond
  {
    Index cell = NoIndex;
    bool isFixed = false;
  };

  Index cellAt(const GridPoint& point) const;
  bool contains(Index cell, const GridPoint& point) const;
  Beyond beyond(Index cell, std::size_t k) const;
  std::size_t sideTo(Index cell, Index neighbour) const;
  /// Vertices of a cell, and what is beyond the sides opposite to them, there with a link back.
  void set(Index cell, const std::array<Index, 3>& vertices, const std::array<Beyond, 3>& beyond);
  Index addCell();
  void splitCell(Index cell, Index vertex);
  void splitSide(Index cell, std::size_t k, Index vertex);
  void legalize(std::vector<Index> cells, Index vertex);
  bool isInCircle(const Side& side) const;

  std::vector<GridPoint> Points;
  std::vector<Index> CellOf; ///< of each vertex one around it
  std::vector<Cell> Cells;
  Index Last = 0; ///< where the search for a point begins
};

} // namespace evolving

#endif
