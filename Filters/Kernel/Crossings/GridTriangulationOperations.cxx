// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/GridTriangulation.h"

#include <algorithm>

namespace evolving
{

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
      if (other.vertices[nextInCell(j)] == vertices[previousInCell(k)] &&
        other.vertices[previousInCell(j)] == vertices[nextInCell(k)])
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
  const Index b = old.vertices[nextInCell(k)];
  const Index c = old.vertices[previousInCell(k)];
  const Index other = old.across[k];
  const bool isFixed = old.isFixed[k];
  const Beyond beyondB = this->beyond(cell, nextInCell(k));
  const Beyond beyondC = this->beyond(cell, previousInCell(k));
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
  const Beyond otherB = this->beyond(other, previousInCell(j)); // its vertices are d, c, b
  const Beyond otherC = this->beyond(other, nextInCell(j));
  const Index fourth = this->addCell();
  this->set(cell, { a, b, vertex }, { Beyond{ other, isFixed }, Beyond{ second }, beyondC });
  this->set(second, { a, vertex, c }, { Beyond{ fourth, isFixed }, beyondB, Beyond{ cell } });
  this->set(other, { d, vertex, b }, { Beyond{ cell, isFixed }, otherC, Beyond{ fourth } });
  this->set(fourth, { d, c, vertex }, { Beyond{ second, isFixed }, Beyond{ other }, otherB });
  this->legalize({ cell, second, other, fourth }, vertex);
}

void GridTriangulation::flip(const Side& side)
{
  const Index cell = side.cell;
  const std::size_t k = side.k;
  const Cell old = this->Cells[at(cell)];
  const Index other = old.across[k];
  const std::size_t j = this->sideTo(other, cell);
  const Index a = old.vertices[k];
  const Index b = old.vertices[nextInCell(k)];
  const Index c = old.vertices[previousInCell(k)];
  const Index d = this->Cells[at(other)].vertices[j];
  const Beyond beyondB = this->beyond(cell, nextInCell(k));
  const Beyond beyondC = this->beyond(cell, previousInCell(k));
  const Beyond otherB = this->beyond(other, previousInCell(j));
  const Beyond otherC = this->beyond(other, nextInCell(j));
  this->set(cell, { a, b, d }, { otherC, Beyond{ other }, beyondC });
  this->set(other, { a, d, c }, { otherB, beyondB, Beyond{ cell } });
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

} // namespace evolving
