// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/SegmentInsertion.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace evolving
{

namespace
{

using Side = GridTriangulation::Side;
using Edge = std::array<Index, 2>; ///< its vertices

std::size_t placeOf(const std::array<Index, 3>& vertices, Index vertex)
{
  return static_cast<std::size_t>(
    std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin());
}

/// From one vertex to the next that the segment meets.
class Stretch
{
public:
  Stretch(GridTriangulation& cells, Index from, Index to)
    : Cells(cells)
    , From(from)
    , To(to)
  {
  }

  /// @return the vertex that it leads to, NoIndex where it cannot
  Index insert()
  {
    if (const std::optional<Side> first = this->firstCrossed())
    {
      if (!this->findCrossed(*first) || !this->flipAway())
      {
        return NoIndex;
      }
    }
    const std::optional<Side> side = this->Cells.sideBetween(this->From, this->To);
    if (!side)
    {
      return NoIndex;
    }
    this->Cells.fix(*side);
    return this->To;
  }

private:
  /// The first side that is crossed; none where it runs along an edge, whose end becomes To.
  std::optional<Side> firstCrossed()
  {
    for (const Index cell : this->Cells.cellsAround(this->From))
    {
      const auto& v = this->Cells.cell(cell);
      const std::size_t k = placeOf(v, this->From);
      const Index right = v[nextInCell(k)];
      const Index left = v[previousInCell(k)];
      for (const Index vertex : { right, left })
      {
        if (this->Cells.orientation(this->From, this->To, vertex) == 0 &&
          isAhead(
            this->Cells.point(this->From), this->Cells.point(this->To), this->Cells.point(vertex)))
        {
          this->To = vertex;
          return std::nullopt;
        }
      }
      if (this->Cells.orientation(this->From, right, this->To) > 0 &&
        this->Cells.orientation(this->From, left, this->To) < 0)
      {
        return Side{ cell, k };
      }
    }
    return std::nullopt;
  }

  /// All edges that are crossed up to the first vertex that is met, which becomes To.
  /// @return false where one is fixed
  bool findCrossed(Side side)
  {
    for (;;)
    {
      if (this->Cells.isFixed(side))
      {
        return false;
      }
      const auto& v = this->Cells.cell(side.cell);
      const Index right = v[nextInCell(side.k)];
      const Index left = v[previousInCell(side.k)];
      this->Crossed.push_back({ right, left });
      const Index ahead = this->Cells.opposite(side);
      const int turn = this->Cells.orientation(this->From, this->To, ahead);
      if (turn == 0)
      {
        this->To = ahead;
        return true;
      }
      // The next one is between what is ahead and the end on the other side of the segment.
      const Index cell = this->Cells.across(side);
      side = { cell, placeOf(this->Cells.cell(cell), turn > 0 ? left : right) };
    }
  }

  /// An edge whose two cells are not convex waits until others are flipped; one of them can be.
  bool flipAway()
  {
    std::size_t waiting = 0;
    for (std::size_t i = 0; i < this->Crossed.size() && waiting <= this->Crossed.size() - i; ++i)
    {
      const Edge edge = this->Crossed[i];
      const std::optional<Side> side = this->Cells.sideBetween(edge[0], edge[1]);
      if (!side || !this->Cells.isFlippable(*side))
      {
        ++waiting;
        this->Crossed.push_back(edge);
        continue;
      }
      waiting = 0;
      const Edge flipped = { this->Cells.cell(side->cell)[side->k], this->Cells.opposite(*side) };
      this->Cells.flip(*side);
      if (this->crosses(flipped))
      {
        this->Crossed.push_back(flipped);
      }
    }
    return waiting == 0;
  }

  /// 0 for the segment's ends.
  int sideOf(Index vertex) const
  {
    return vertex == this->From || vertex == this->To
      ? 0
      : this->Cells.orientation(this->From, this->To, vertex);
  }

  bool crosses(const Edge& edge) const { return this->sideOf(edge[0]) * this->sideOf(edge[1]) < 0; }

  GridTriangulation& Cells;
  Index From;
  Index To;
  std::vector<Edge> Crossed;
};

} // namespace

bool insertSegment(GridTriangulation& cells, Index from, Index to)
{
  while (from != to && from != NoIndex)
  {
    from = Stretch(cells, from, to).insert();
  }
  return from == to;
}

} // namespace evolving
