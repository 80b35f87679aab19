// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/NormalEquations.h"

#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

NormalEquations::NormalEquations(
  const EditableSurface& surface, const std::vector<Index>& firstUnknown, Index perVertex)
  : Surface(surface)
  , FirstUnknown(firstUnknown)
  , PerVertex(perVertex)
{
  this->findEntries();
}

void NormalEquations::findEntries()
{
  const auto vertices = static_cast<Index>(this->FirstUnknown.size()) -
    static_cast<Index>(std::count(this->FirstUnknown.begin(), this->FirstUnknown.end(), NoIndex));
  const Index unknowns = this->PerVertex * vertices;
  this->System.resize(unknowns, unknowns);
  this->RightSide.resize(at(unknowns));
  std::vector<Index> columns;
  for (Index v = 0; v < this->Surface.vertexSlots(); ++v)
  {
    const Index first = this->FirstUnknown[at(v)];
    const std::vector<Index> around =
      first != NoIndex ? this->unknownsAround(v) : std::vector<Index>{};
    for (Index d = 0; first != NoIndex && d < this->PerVertex; ++d)
    {
      this->System.outerIndexPtr()[first + d] = static_cast<Index>(columns.size());
      for (const Index unknown : around)
      {
        for (Index c = 0; c < this->PerVertex; ++c)
        {
          columns.push_back(unknown + c);
        }
      }
    }
  }
  this->System.outerIndexPtr()[unknowns] = static_cast<Index>(columns.size());
  this->System.resizeNonZeros(static_cast<Eigen::Index>(columns.size()));
  std::copy(columns.begin(), columns.end(), this->System.innerIndexPtr());
}

/// The first ones of the vertex and its neighbours, in ascending order.
std::vector<Index> NormalEquations::unknownsAround(Index v) const
{
  std::vector<Index> unknowns{ this->FirstUnknown[at(v)] };
  this->Surface.forEachNeighbour(v,
    [&](Index u)
    {
      if (this->FirstUnknown[at(u)] != NoIndex)
      {
        unknowns.push_back(this->FirstUnknown[at(u)]);
      }
    });
  std::sort(unknowns.begin(), unknowns.end());
  return unknowns;
}

void NormalEquations::assemble(const std::vector<FaceTerms>& terms, const Execution& execution)
{
  forEachIndex(execution, this->Surface.vertexSlots(),
    [&](Index v)
    {
      if (this->FirstUnknown[at(v)] != NoIndex)
      {
        this->assembleRowsOf(v, terms);
      }
    });
}

void NormalEquations::assembleRowsOf(Index v, const std::vector<FaceTerms>& terms)
{
  const Index first = this->FirstUnknown[at(v)];
  const Index begin = this->System.outerIndexPtr()[first];
  const Index length = this->System.outerIndexPtr()[first + 1] - begin;
  const Index* columns = this->System.innerIndexPtr() + begin;
  double* values = this->System.valuePtr() + begin;
  std::fill(values, values + this->PerVertex * length, 0.0);
  Eigen::Map<Eigen::VectorXd> rightSide(this->RightSide.data() + first, this->PerVertex);
  rightSide.setZero();
  this->Surface.forEachOutgoing(v,
    [&](Index e)
    {
      const Index face = EditableSurface::faceOf(e);
      const Index row = 3 * (e - 3 * face);
      const FaceTerms& t = terms[at(face)];
      rightSide += t.rightSide.segment(row, this->PerVertex);
      for (Index k = 0; k < 3; ++k)
      {
        const Index unknown = this->FirstUnknown[at(this->Surface.from(3 * face + k))];
        if (unknown == NoIndex)
        {
          continue;
        }
        const Index* column = std::lower_bound(columns, columns + length, unknown);
        for (Index d = 0; d < this->PerVertex; ++d)
        {
          for (Index c = 0; c < this->PerVertex; ++c)
          {
            values[d * length + (column - columns) + c] += t.matrix(row + d, 3 * k + c);
          }
        }
      }
    });
}

} // namespace evolving
