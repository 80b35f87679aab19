// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Curves where sheets meet: they lie where the sheets lead to.
 */

#ifndef EVOLVING_JUNCTION_FIT_H
#define EVOLVING_JUNCTION_FIT_H

#include "Algebra/MinimalResidual.h"
#include "Algebra/SparseMatrix.h"
#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/NetLimits.h"
#include "LabelSurfaces/SheetEnds.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * The corners of voxels along a curve where three labels meet lie beside it by half a voxel and
 * more, and there are too few of them to average over. Sheets are known much better, as they are
 * averaged over an area. So every vertex of a curve moves onto the planes in which its sheets end
 * (SheetEnds). Along the curve, and where sheets are too small to say, it follows its neighbours,
 * bent as little as can be.
 * Curves in the sides of the image are not concerned.
 */
class JunctionFit : public SymmetricOperator
{
public:
  /// @param limits vertices that do not slide follow their neighbours alone
  /// @param radius of the part of a sheet that counts, in voxels
  JunctionFit(const InterfaceNet& net, const NetLimits& limits, double radius);

  /// @throws SolverError, Cancelled
  void apply(std::vector<Vec3>& points, const Execution& execution);

  /// Of moves, three numbers for each vertex of a curve.
  void apply(const std::vector<double>& x, std::vector<double>& y,
    const Execution& execution) const override;

private:
  void fit(Index number, const std::vector<Vec3>& points, const std::vector<Vec3>& areas);
  SparseMatrix bendingMatrix() const;
  std::vector<Vec3> bending(const std::vector<Vec3>& x, const Execution& execution) const;

  const InterfaceNet& Net;
  const NetLimits& Limits;
  SheetEnds Ends;
  std::vector<Index> Vertices; ///< all that are fitted; their places here are their numbers
  SparseMatrix A;
  SparseMatrix Transposed;
  std::vector<Eigen::Matrix3d> Planes; ///< sum of w n n^T
  std::vector<Vec3> Pulls;             ///< sum of w offset n
};

} // namespace evolving

#endif
