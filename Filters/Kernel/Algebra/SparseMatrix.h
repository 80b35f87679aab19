// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Sparse symmetric matrices by rows, applied to one value or one point per vertex.
 */

#ifndef EVOLVING_SPARSE_MATRIX_H
#define EVOLVING_SPARSE_MATRIX_H

#include "Execution.h"
#include "Types.h"

#include <Eigen/SparseCore>

#include <vector>

namespace evolving
{

/// Compressed rows, columns ascending. The pattern follows the connectivity of a mesh.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>;

inline Index rowCount(const SparseMatrix& A)
{
  return static_cast<Index>(A.rows());
}

/// Calls visit(column, value) for the stored entries of a row.
template <class Visit>
void forEachEntry(const SparseMatrix& A, Index row, const Visit& visit)
{
  for (Index k = A.outerIndexPtr()[row]; k < A.outerIndexPtr()[row + 1]; ++k)
  {
    visit(A.innerIndexPtr()[k], A.valuePtr()[k]);
  }
}

/// a_ii; 0 when it is not stored.
inline double diagonalEntry(const SparseMatrix& A, Index row)
{
  const Index* columns = A.innerIndexPtr();
  for (Index k = A.outerIndexPtr()[row]; k < A.outerIndexPtr()[row + 1]; ++k)
  {
    if (columns[k] == row)
    {
      return A.valuePtr()[k];
    }
  }
  return 0.0;
}

/// Values on vertices are numbers or points; both have an inner product and a zero.
inline double dot(double x, double y)
{
  return x * y;
}

inline double dot(const Vec3& x, const Vec3& y)
{
  return x.dot(y);
}

template <class Value>
Value zero()
{
  return Value(Value::Zero());
}

template <>
inline double zero<double>()
{
  return 0.0;
}

/// y = A x. Value is double or Vec3 (then A acts on each coordinate).
template <class Value>
void multiply(const SparseMatrix& A, const std::vector<Value>& x, std::vector<Value>& y,
  const Execution& execution);

/// y = A x; returns the inner product of x and y.
template <class Value>
double multiplyAndDot(const SparseMatrix& A, const std::vector<Value>& x, std::vector<Value>& y,
  const Execution& execution);

/**
 * Makes rows with a known solution into identity rows and moves their columns to the right-hand
 * side, so that the matrix stays symmetric and keeps its pattern.
 * @param isKnown one flag per row
 * @param known the solution in the rows with a flag; other entries are not read
 * @param[in,out] A a matrix with a stored diagonal
 * @param[in,out] b the right-hand side
 */
template <class Value>
void eliminateKnown(const std::vector<char>& isKnown, const std::vector<Value>& known,
  SparseMatrix& A, std::vector<Value>& b, const Execution& execution);

/// 1 / a_ii for every row; 1 where the diagonal is not positive.
std::vector<double> inverseDiagonal(const SparseMatrix& A, const Execution& execution);

} // namespace evolving

#endif
