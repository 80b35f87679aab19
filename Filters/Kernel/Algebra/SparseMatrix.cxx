// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/SparseMatrix.h"

#include "ParallelLoops.h"

namespace evolving
{

namespace
{

/// Written out, since most of a solve's time is spent here: compilers keep a sum that a visitor
/// refers to in memory.
template <class Value>
Value rowTimes(const SparseMatrix& A, Index row, const std::vector<Value>& x)
{
  const Index* columns = A.innerIndexPtr();
  const double* values = A.valuePtr();
  const Index end = A.outerIndexPtr()[row + 1];
  Value sum = zero<Value>();
  for (Index k = A.outerIndexPtr()[row]; k < end; ++k)
  {
    sum += values[k] * x[at(columns[k])];
  }
  return sum;
}

} // namespace

template <class Value>
void multiply(const SparseMatrix& A, const std::vector<Value>& x, std::vector<Value>& y,
  const Execution& execution)
{
  y.resize(at(rowCount(A)));
  forEachIndex(execution, A.rows(), [&](Index row) { y[at(row)] = rowTimes(A, row, x); });
}

template <class Value>
double multiplyAndDot(const SparseMatrix& A, const std::vector<Value>& x, std::vector<Value>& y,
  const Execution& execution)
{
  y.resize(at(rowCount(A)));
  return sumEachIndex(execution, A.rows(),
    [&](Index row)
    {
      y[at(row)] = rowTimes(A, row, x);
      return dot(x[at(row)], y[at(row)]);
    });
}

template <class Value>
void eliminateKnown(const std::vector<char>& isKnown, const std::vector<Value>& known,
  SparseMatrix& A, std::vector<Value>& b, const Execution& execution)
{
  forEachIndex(execution, A.rows(),
    [&](Index row)
    {
      const Index* columns = A.innerIndexPtr();
      double* values = A.valuePtr();
      for (Index k = A.outerIndexPtr()[row]; k < A.outerIndexPtr()[row + 1]; ++k)
      {
        const Index column = columns[k];
        if (isKnown[at(row)])
        {
          values[k] = column == row ? 1.0 : 0.0;
        }
        else if (isKnown[at(column)])
        {
          b[at(row)] -= values[k] * known[at(column)];
          values[k] = 0.0;
        }
      }
      if (isKnown[at(row)])
      {
        b[at(row)] = known[at(row)];
      }
    });
}

std::vector<double> inverseDiagonal(const SparseMatrix& A, const Execution& execution)
{
  std::vector<double> inverse(at(rowCount(A)));
  forEachIndex(execution, rowCount(A),
    [&](Index row)
    {
      const double diagonal = diagonalEntry(A, row);
      inverse[at(row)] = diagonal > 0.0 ? 1.0 / diagonal : 1.0;
    });
  return inverse;
}

template void multiply(
  const SparseMatrix&, const std::vector<double>&, std::vector<double>&, const Execution&);
template void multiply(
  const SparseMatrix&, const std::vector<Vec3>&, std::vector<Vec3>&, const Execution&);
template double multiplyAndDot(
  const SparseMatrix&, const std::vector<double>&, std::vector<double>&, const Execution&);
template double multiplyAndDot(
  const SparseMatrix&, const std::vector<Vec3>&, std::vector<Vec3>&, const Execution&);
template void eliminateKnown(const std::vector<char>&, const std::vector<double>&, SparseMatrix&,
  std::vector<double>&, const Execution&);
template void eliminateKnown(const std::vector<char>&, const std::vector<Vec3>&, SparseMatrix&,
  std::vector<Vec3>&, const Execution&);

} // namespace evolving
