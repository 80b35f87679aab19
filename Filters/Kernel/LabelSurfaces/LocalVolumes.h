// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What smoothing has taken away from a place, given back to that place.
 */

#ifndef EVOLVING_LOCAL_VOLUMES_H
#define EVOLVING_LOCAL_VOLUMES_H

#include "Algebra/SparseMatrix.h"
#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// The area vectors of vertices of sheets, a quarter of those of their quads, towards the larger
/// material; zero for other vertices.
std::vector<Vec3> sheetAreas(
  const InterfaceNet& net, const std::vector<Vec3>& points, const Execution& execution);

/// Their directions; zero where an area is.
std::vector<Vec3> directionsOf(std::vector<Vec3> areas, const Execution& execution);

/**
 * A filter that shortens waves also shrinks what is round, and a thread of one voxel at once. Steps
 * go to and fro about the shape, so what they lose and win adds up to nothing over their length;
 * what is left of the volume moved at each vertex, smoothed along the sheet, is what the shape has
 * lost there. It is given back along the normals, as smoothly as it was found. Of outlines in the
 * sides of the image it is the move itself, smoothed along them; other curves where sheets meet
 * stay (JunctionFit).
 */
class LocalVolumes
{
public:
  /// @param length over which what is lost adds up to nothing, in voxels
  LocalVolumes(const InterfaceNet& net, double length, const Execution& execution);

  /// @throws SolverError, Cancelled
  void giveBack(
    const std::vector<Vec3>& before, std::vector<Vec3>& points, const Execution& execution) const;

private:
  const InterfaceNet& Net;
  SparseMatrix Smoothing; ///< I + length^2 / 4 (D - W), on sheets and on outlines
};

} // namespace evolving

#endif
