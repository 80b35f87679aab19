// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The volumes of labels, and how they become those of their voxels.
 */

#ifndef EVOLVING_LABEL_VOLUMES_H
#define EVOLVING_LABEL_VOLUMES_H

#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/InterfaceTriangles.h"
#include "LabelSurfaces/NetLimits.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// Of every label, number 1 first. In voxels, where the points are.
std::vector<double> labelVolumes(const InterfaceNet& net, const InterfaceTriangles& triangles,
  const std::vector<Vec3>& points, std::size_t labelCount, const Execution& execution);

/**
 * A Lagrange multiplier for each label: its surface moves along the gradient of its volume until
 * that is as wanted. Labels that touch are coupled by the interfaces they share, so all multipliers
 * are solved for at once, by Newton's method. Points stay where they may be; where that leaves a
 * label no way, its volume remains as near as it comes.
 */
class LabelVolumes
{
public:
  /// @param volumes wanted, one for each label, number 1 first
  LabelVolumes(const InterfaceNet& net, const InterfaceTriangles& triangles,
    const NetLimits& limits, std::vector<double> volumes);

  /**
   * @param rests vertices that do not move
   * @return the largest error that is left, relative to the wanted volume
   * @throws SolverError, Cancelled
   */
  double restore(
    const std::vector<char>& rests, std::vector<Vec3>& points, const Execution& execution) const;

private:
  std::vector<double> multipliers(const std::vector<double>& missing,
    const std::vector<char>& rests, const std::vector<Vec3>& points,
    const Execution& execution) const;
  double largestError(const std::vector<double>& missing) const;

  const InterfaceNet& Net;
  const InterfaceTriangles& Triangles;
  CornersOfVertices Corners;
  const NetLimits& Limits;
  std::vector<double> Volumes;
};

} // namespace evolving

#endif
