// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The linear system of a least-squares fit of faces.
 */

#ifndef EVOLVING_NORMAL_EQUATIONS_H
#define EVOLVING_NORMAL_EQUATIONS_H

#include "Algebra/SparseMatrix.h"
#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

#include <Eigen/Core>

#include <vector>

namespace evolving
{

/// A face's part of the system, in three unknowns of each of its three vertices.
struct FaceTerms
{
  Eigen::Matrix<double, 9, 9> matrix = Eigen::Matrix<double, 9, 9>::Zero();
  Eigen::Matrix<double, 9, 1> rightSide = Eigen::Matrix<double, 9, 1>::Zero();
};

/**
 * A symmetric system with the first few of the three unknowns of each vertex that has any. Every
 * vertex gathers its rows from its faces, so they are filled side by side; which entries there are
 * is found once.
 */
class NormalEquations
{
public:
  /**
   * @param surface keeps its connectivity from now on
   * @param firstUnknown per vertex; NoIndex: none. In ascending order
   * @param perVertex how many unknowns, at most 3
   */
  NormalEquations(
    const EditableSurface& surface, const std::vector<Index>& firstUnknown, Index perVertex);

  /// @param terms one per face
  void assemble(const std::vector<FaceTerms>& terms, const Execution& execution);

  SparseMatrix& matrix() { return this->System; }
  const std::vector<double>& rightSide() const { return this->RightSide; }

private:
  void findEntries();
  std::vector<Index> unknownsAround(Index v) const;
  void assembleRowsOf(Index v, const std::vector<FaceTerms>& terms);

  const EditableSurface& Surface;
  const std::vector<Index>& FirstUnknown;
  Index PerVertex;
  SparseMatrix System;
  std::vector<double> RightSide;
};

} // namespace evolving

#endif
