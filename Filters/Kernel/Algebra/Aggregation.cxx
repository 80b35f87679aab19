// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/Aggregation.h"

#include "ParallelLoops.h"

#include <cmath>

namespace evolving
{

namespace
{

class Aggregator
{
public:
  Aggregator(const SparseMatrix& matrix, double threshold)
    : A(matrix)
    , Threshold(threshold)
    , Diagonal(matrix.diagonal())
  {
    this->Result.aggregateOfRow.assign(at(rowCount(matrix)), NoIndex);
  }

  Aggregation run()
  {
    this->forEachFreeRow([this](Index row) { this->beginWithWholeNeighbourhood(row); });
    const std::vector<Index> begun = this->Result.aggregateOfRow;
    this->forEachFreeRow([&](Index row) { this->joinStrongest(row, begun); });
    this->forEachFreeRow([this](Index row) { this->beginWithFreeNeighbours(row); });
    return std::move(this->Result);
  }

private:
  template <class Visit>
  void forEachFreeRow(const Visit& visit)
  {
    for (Index row = 0; row < rowCount(this->A); ++row)
    {
      if (this->aggregateOf(row) == NoIndex)
      {
        visit(row);
      }
    }
  }

  template <class Visit>
  void forEachStrong(Index row, const Visit& visit) const
  {
    forEachEntry(this->A, row,
      [&](Index column, double value)
      {
        const double scale = std::sqrt(this->Diagonal[row] * this->Diagonal[column]);
        const double strength = std::abs(value);
        if (column != row && strength > 0.0 && strength >= this->Threshold * scale)
        {
          visit(column, strength);
        }
      });
  }

  Index& aggregateOf(Index row) { return this->Result.aggregateOfRow[at(row)]; }

  void beginWithWholeNeighbourhood(Index row)
  {
    bool connected = false;
    bool free = true;
    this->forEachStrong(row,
      [&](Index neighbour, double)
      {
        connected = true;
        free = free && this->aggregateOf(neighbour) == NoIndex;
      });
    if (connected && free)
    {
      this->begin(row);
    }
  }

  void beginWithFreeNeighbours(Index row)
  {
    bool connected = false;
    this->forEachStrong(row, [&](Index, double) { connected = true; });
    if (connected)
    {
      this->begin(row);
    }
  }

  void begin(Index row)
  {
    const Index aggregate = this->Result.count++;
    this->aggregateOf(row) = aggregate;
    this->forEachStrong(row,
      [&](Index neighbour, double)
      {
        Index& of = this->aggregateOf(neighbour);
        of = of == NoIndex ? aggregate : of;
      });
  }

  void joinStrongest(Index row, const std::vector<Index>& begun)
  {
    double strongest = 0.0;
    this->forEachStrong(row,
      [&](Index neighbour, double strength)
      {
        if (begun[at(neighbour)] != NoIndex && strength > strongest)
        {
          strongest = strength;
          this->aggregateOf(row) = begun[at(neighbour)];
        }
      });
  }

  const SparseMatrix& A;
  double Threshold;
  Eigen::VectorXd Diagonal;
  Aggregation Result;
};

} // namespace

Aggregation aggregate(const SparseMatrix& A, double threshold)
{
  return Aggregator(A, threshold).run();
}

} // namespace evolving
