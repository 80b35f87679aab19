// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * From options and input to the numbers that an evolution runs with.
 */

#ifndef EVOLVING_FLOW_SETUP_H
#define EVOLVING_FLOW_SETUP_H

#include "Evolution/FlowOptions.h"
#include "Evolution/ScalarImage.h"
#include "Mesh/SurfaceMesh.h"
#include "Redistribution/SubSteps.h"

namespace evolving
{

struct FlowSetup
{
  FlowOptions options;     ///< in absolute units, with a time step; rates as a sub-step bears them
  double size = 1.0;       ///< L, whether or not the options were relative
  double lengthUnit = 1.0; ///< what the options were scaled by
  SubSteps parts;          ///< of every time step
  /// A vertex that moves less along its normal in a step is at rest: by convergenceTolerance times
  /// L in the flow's own time, 1 / C towards a target, and L^2 / C1 by curvature alone (L^4 / C1 by
  /// surface diffusion). So neither units nor step lengths count, and no closed surface rests, for
  /// somewhere its H is at least 2 / L.
  double restingMove = 0.0;
};

/**
 * L is half the diagonal of the box of samples with d <= 0; without a field or such samples, and
 * for an edge detector, of the start's box.
 * @param field may be null
 * @throws InputError for options out of range, a start without area, or a flow that holds volumes
 * with a field or with a boundary that it cannot have
 */
FlowSetup setUpFlow(const SurfaceMesh& start, const ScalarImage* field, const FlowOptions& options);

} // namespace evolving

#endif
