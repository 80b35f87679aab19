// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A net without the stairs of its voxels.
 */

#ifndef EVOLVING_NET_SMOOTHING_H
#define EVOLVING_NET_SMOOTHING_H

#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/NetLimits.h"

namespace evolving
{

/**
 * Some times over, sheets are bent less (NetFairing) and get back what that took from places
 * (LocalVolumes), curves go where the sheets lead to (JunctionFit), and all go back to where they
 * may be.
 * @param length in voxels; 0 leaves the net as it is
 * @throws SolverError, Cancelled
 */
void smoothNet(
  const NetLimits& limits, double length, InterfaceNet& net, const Execution& execution);

} // namespace evolving

#endif
