// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/GridTriangulation.h"

#include <algorithm>
#include <utility>

namespace evolving
{

namespace
{

std::size_t next(std::size_t k)
{
  return (k + 1) % 3;
}

std::size_t previous(std::size_t k)
{
  return (k + 2) % 3;
}

} // namespace

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
    if (gridOrientation(this->Points[at(v[next(k)])], this->Points[at(v[previous(k)])], point) < 0)
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
      gridOrientation(this->Points[at(c.vertices[next(k)])],
        this->Points[at(c.vertices[previous(k)])], point) >= 0)
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

void GridTriangulation::set(
  Index cell, const std::array<Index, 3>& vertices, const std::array<Beyond, 3>& beyond)
{
  Cell& c = this->Cells[at(cell)];
  c.vertices = vertices;
  for (std::size_t k = 0; k < 3; ++k)
  {
    c.across[k] = beyond[k].cell;
    c.isFixed[k] = beyond[k].isFixed;
    this->CellOf[at(vertices[k])] = cell;
    if (beyond[k].cell == NoIndex)
    {
      continue;
    }
    Cell& other = this->Cells[at(beyond[k].cell)];
    for (std::size_t j = 0; j < 3; ++j)
    {
      if (other.vertices[next(j)] == vertices[previous(k)] &&
        other.vertices[previous(j)] == vertices[next(k)])
      {
        other.across[j] = cell;
      }
    }
  }
}

Index GridTriangulation::addCell()
{
  this->Cells.emplace_back();
  return this->cellCount() - 1;
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
    const GridPoint& begin = this->Points[at(v[next(k)])];
    const GridPoint& end = this->Points[at(v[previous(k)])];
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

void GridTriangulation::splitCell(Index cell, Index vertex)
{
  const auto [a, b, c] = this->cell(cell);
  const Beyond beyondA = this->beyond(cell, 0);
  const Beyond beyondB = this->beyond(cell, 1);
  const Beyond beyondC = this->beyond(cell, 2);
  const Index second = this->addCell();
  const Index third = this->addCell();
  this->set(cell, { vertex, b, c }, { beyondA, Beyond{ second }, Beyond{ third } });
  this->set(second, { vertex, c, a }, { beyondB, Beyond{ third }, Beyond{ cell } });
  this->set(third, { vertex, a, b }, { beyondC, Beyond{ cell }, Beyond{ second } });
  this->legalize({ cell, second, third }, vertex);
}

void GridTriangulation::splitSide(Index cell, std::size_t k, Index vertex)
{
  const Cell old = this->Cells[at(cell)];
  const Index a = old.vertices[k];
  const Index b = old.vertices[next(k)];
  const Index c = old.vertices[previous(k)];
  const Index other = old.across[k];
  const bool isFixed = old.isFixed[k];
  const Beyond beyondB = this->beyond(cell, next(k));
  const Beyond beyondC = this->beyond(cell, previous(k));
  const Index second = this->addCell();
  if (other == NoIndex)
  {
    this->set(cell, { a, b, vertex }, { Beyond{}, Beyond{ second }, beyondC });
    this->set(second, { a, vertex, c }, { Beyond{}, beyondB, Beyond{ cell } });
    this->legalize({ cell, second }, vertex);
    return;
  }
  const std::size_t j = this->sideTo(other, cell);
  const Index d = this->Cells[at(other)].vertices[j];
  const Beyond otherB = this->beyond(other, previous(j)); // its vertices are d, c, b
  const Beyond otherC = this->beyond(other, next(j));
  const Index fourth = this->addCell();
  this->set(cell, { a, b, vertex }, { Beyond{ other, isFixed }, Beyond{ second }, beyondC });
  this->set(second, { a, vertex, c }, { Beyond{ fourth, isFixed }, beyondB, Beyond{ cell } });
  this->set(other, { d, vertex, b }, { Beyond{ cell, isFixed }, otherC, Beyond{ fourth } });
  this->set(fourth, { d, c, vertex }, { Beyond{ second, isFixed }, Beyond{ other }, otherB });
  this->legalize({ cell, second, other, fourth }, vertex);
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
  return this->orientation(a, c.vertices[next(side.k)], d) > 0 &&
    this->orientation(a, d, c.vertices[previous(side.k)]) > 0;
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

void GridTriangulation::flip(const Side& side)
{
  const Index cell = side.cell;
  const std::size_t k = side.k;
  const Cell old = this->Cells[at(cell)];
  const Index other = old.across[k];
  const std::size_t j = this->sideTo(other, cell);
  const Index a = old.vertices[k];
  const Index b = old.vertices[next(k)];
  const Index c = old.vertices[previous(k)];
  const Index d = this->Cells[at(other)].vertices[j];
  const Beyond beyondB = this->beyond(cell, next(k));
  const Beyond beyondC = this->beyond(cell, previous(k));
  const Beyond otherB = this->beyond(other, previous(j));
  const Beyond otherC = this->beyond(other, next(j));
  this->set(cell, { a, b, d }, { otherC, Beyond{ other }, beyondC });
  this->set(other, { a, d, c }, { otherB, beyondB, Beyond{ cell } });
}

/// Every flip adds an edge at the vertex, so this ends whatever rounding says of circles.
void GridTriangulation::legalize(std::vector<Index> cells, Index vertex)
{
  while (!cells.empty())
  {
    const Index cell = cells.back();
    cells.pop_back();
    const auto& v = this->cell(cell);
    const auto k = static_cast<std::size_t>(std::find(v.begin(), v.end(), vertex) - v.begin());
    const Side side{ cell, k };
    if (this->isFlippable(side) && this->isInCircle(side))
    {
      const Index other = this->Cells[at(cell)].across[k];
      this->flip(side);
      cells.push_back(cell);
      cells.push_back(other);
    }
  }
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
  if (!walk(next))
  {
    walk(previous);
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
      const Index begin = v[next(k)];
      const Index end = v[previous(k)];
      if ((begin == a && end == b) || (begin == b && end == a))
      {
        return Side{ cell, k };
      }
    }
  }
  return std::nullopt;
}

void GridTriangulation::fix(const Side& side)
{
  Cell& c = this->Cells[at(side.cell)];
  c.isFixed[side.k] = true;
  if (c.across[side.k] != NoIndex)
  {
    const std::size_t j = this->sideTo(c.across[side.k], side.cell);
    this->Cells[at(c.across[side.k])].isFixed[j] = true;
  }
}

} // namespace evolving
