// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Interfaces without steps: each as little bent as can be.
 */

#ifndef EVOLVING_NET_FAIRING_H
#define EVOLVING_NET_FAIRING_H

#include "Algebra/MinimalResidual.h"
#include "Algebra/SparseMatrix.h"
#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * The linear low-pass filter I + t A^T W A of a net: with u_i the mean of a vertex's neighbours
 * less the vertex itself, points x become those that minimize
 *
 *   sum |y_i - x_i|^2 + t sum w_i |u_i(y)|^2
 *
 * Neighbours are all, within a sheet, and those along the outline in a side of the image. Where
 * sheets meet within it, vertices stay (JunctionFit puts them where they are to be), and sheets end
 * there as plates do on a support, at any angle. A wave of length l is damped by
 * 1 / (1 + t (pi / l)^4) at least.
 */
class NetFairing : public SymmetricOperator
{
public:
  NetFairing(const InterfaceNet& net, double strength, const Execution& execution);

  /// @throws SolverError, Cancelled
  void apply(std::vector<Vec3>& points, const Execution& execution) const;

  /// Of moves, three numbers for each vertex.
  void apply(const std::vector<double>& x, std::vector<double>& y,
    const Execution& execution) const override;

private:
  std::vector<Vec3> bending(const std::vector<Vec3>& points, const Execution& execution) const;

  const InterfaceNet& Net;
  SparseMatrix A;          ///< scaled by the root of t w
  SparseMatrix Transposed; ///< A^T
  std::vector<double> InverseDiagonal;
};

} // namespace evolving

#endif
