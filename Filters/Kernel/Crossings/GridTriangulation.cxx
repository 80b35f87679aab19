// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/GridTriangulation.h"

#include <algorithm>
#include <utility>

namespace evolving
{

GridTriangulation::GridTriangulation()
  : Points({ { 0, 0 }, { GridPoint::Unit, 0 }, { 0, GridPoint::Unit } })
  , CellOf(3, 0)
  , Cells(1)
{
  this->Cells.front().vertices = { 0, 1, 2 };
}

int GridTriangulation::orientation(Index a, Index b, Index c) const
{
  return gridOrientation(this->Points[at(a)], this->Points[at(b)], this->Points[at(c)]);
}

bool GridTriangulation::contains(Index cell, const GridPoint& point) const
{
  const auto& v = this->Cells[at(cell)].vertices;
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (gridOrientation(
          this->Points[at(v[nextInCell(k)])], this->Points[at(v[previousInCell(k)])], point) < 0)
    {
      return false;
    }
  }
  return true;
}

Index GridTriangulation::cellAt(const GridPoint& point) const
{
  // Towards the point, from cell to cell; that may go round in circles where segments are.
  Index cell = this->Last;
  for (Index step = 0; step < this->cellCount(); ++step)
  {
    const Cell& c = this->Cells[at(cell)];
    std::size_t k = 0;
    while (k < 3 &&
      gridOrientation(this->Points[at(c.vertices[nextInCell(k)])],
        this->Points[at(c.vertices[previousInCell(k)])], point) >= 0)
    {
      ++k;
    }
    if (k == 3)
    {
      return cell;
    }
    cell = c.across[k];
  }
  for (cell = 0; !this->contains(cell, point); ++cell)
  {
  }
  return cell;
}

GridTriangulation::Beyond GridTriangulation::beyond(Index cell, std::size_t k) const
{
  return { this->Cells[at(cell)].across[k], this->Cells[at(cell)].isFixed[k] };
}

std::size_t GridTriangulation::sideTo(Index cell, Index neighbour) const
{
  const auto& across = this->Cells[at(cell)].across;
  return static_cast<std::size_t>(
    std::find(across.begin(), across.end(), neighbour) - across.begin());
}

Index GridTriangulation::insert(const GridPoint& point)
{
  const Index cell = this->cellAt(point);
  const std::array<Index, 3> v = this->cell(cell);
  std::size_t touched = 3;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const GridPoint& corner = this->Points[at(v[k])];
    if (corner.x == point.x && corner.y == point.y)
    {
      return v[k];
    }
    const GridPoint& begin = this->Points[at(v[nextInCell(k)])];
    const GridPoint& end = this->Points[at(v[previousInCell(k)])];
    touched = gridOrientation(begin, end, point) == 0 ? k : touched;
  }
  const Index vertex = this->vertexCount();
  this->Points.push_back(point);
  this->CellOf.push_back(cell);
  if (touched < 3)
  {
    this->splitSide(cell, touched, vertex);
  }
  else
  {
    this->splitCell(cell, vertex);
  }
  this->Last = this->CellOf.back();
  return vertex;
}

Index GridTriangulation::opposite(const Side& side) const
{
  const Index other = this->Cells[at(side.cell)].across[side.k];
  return this->Cells[at(other)].vertices[this->sideTo(other, side.cell)];
}

bool GridTriangulation::isFlippable(const Side& side) const
{
  const Cell& c = this->Cells[at(side.cell)];
  if (c.across[side.k] == NoIndex || c.isFixed[side.k])
  {
    return false;
  }
  const Index a = c.vertices[side.k];
  const Index d = this->opposite(side);
  return this->orientation(a, c.vertices[nextInCell(side.k)], d) > 0 &&
    this->orientation(a, d, c.vertices[previousInCell(side.k)]) > 0;
}

bool GridTriangulation::isInCircle(const Side& side) const
{
  const GridPoint& d = this->Points[at(this->opposite(side))];
  Eigen::Matrix3d rows;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const GridPoint& p = this->Points[at(this->Cells[at(side.cell)].vertices[k])];
    const double x = static_cast<double>(p.x - d.x);
    const double y = static_cast<double>(p.y - d.y);
    rows.row(static_cast<Eigen::Index>(k)) << x, y, x * x + y * y;
  }
  return rows.determinant() > 0.0;
}

std::vector<Index> GridTriangulation::cellsAround(Index vertex) const
{
  std::vector<Index> cells;
  const Index first = this->CellOf[at(vertex)];
  const auto walk = [&](std::size_t (*turn)(std::size_t))
  {
    Index cell = first;
    do
    {
      cells.push_back(cell);
      const Cell& c = this->Cells[at(cell)];
      const auto k = std::find(c.vertices.begin(), c.vertices.end(), vertex) - c.vertices.begin();
      cell = c.across[turn(static_cast<std::size_t>(k))];
    } while (cell != NoIndex && cell != first);
    return cell == first;
  };
  if (!walk(nextInCell))
  {
    walk(previousInCell);
  }
  return cells;
}

std::optional<GridTriangulation::Side> GridTriangulation::sideBetween(Index a, Index b) const
{
  for (const Index cell : this->cellsAround(a))
  {
    const auto& v = this->cell(cell);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index begin = v[nextInCell(k)];
      const Index end = v[previousInCell(k)];
      if ((begin == a && end == b) || (begin == b && end == a))
      {
        return Side{ cell, k };
      }
    }
  }
  return std::nullopt;
}

} // namespace evolving
