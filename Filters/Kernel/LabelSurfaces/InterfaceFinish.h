// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The triangles of a smooth net: good elements, the volumes of the voxels, no intersections.
 */

#ifndef EVOLVING_INTERFACE_FINISH_H
#define EVOLVING_INTERFACE_FINISH_H

#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/InterfaceTriangles.h"
#include "LabelSurfaces/MaterialGrid.h"
#include "LabelSurfaces/NetLimits.h"
#include "Types.h"

#include <Eigen/Geometry>

#include <utility>
#include <vector>

namespace evolving
{

/// Points from numbers of voxels to space.
std::vector<Vec3> inSpace(
  const std::vector<Vec3>& points, const Eigen::Affine3d& toSpace, const Execution& execution);

class InterfaceFinish
{
public:
  /// @param volumes wanted, in voxels, of every label, number 1 first
  /// @param areFloats whether the points will be written as floats, as which they must not
  /// intersect
  InterfaceFinish(const MaterialGrid& grid, const InterfaceNet& net, NetLimits limits,
    const Eigen::Affine3d& toSpace, std::vector<double> volumes, bool areFloats);

  /**
   * Where triangles intersect, their vertices no longer slide; where they still do, they go back
   * towards their corners of voxels and rest there, and all is done once more. Neither takes part
   * in changes of elements; at the corners, nothing can intersect.
   * @param[in,out] points of the net's vertices; some may have no triangles any more
   * @throws SolverError, Cancelled
   */
  InterfaceTriangles run(std::vector<Vec3>& points, const Execution& execution);

private:
  void improve(
    InterfaceTriangles& triangles, std::vector<Vec3>& points, const Execution& execution) const;
  int stage(Index vertex) const;
  void takeBack(const std::vector<std::pair<Index, Index>>& pairs,
    const InterfaceTriangles& triangles, double left, std::vector<Vec3>& points);

  const MaterialGrid& Grid;
  const InterfaceNet& Net;
  NetLimits Limits;
  Eigen::Affine3d ToSpace;
  std::vector<double> Volumes;
  bool AreFloats;
  std::vector<char> IsHeld; ///< vertices whose elements stay as they are
  std::vector<char> Rests;  ///< those of them that do not move at all
};

} // namespace evolving

#endif
