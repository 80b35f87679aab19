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
  FlowOptions options;     ///< in absolute units; rates lowered to what a sub-step bears
  double size = 1.0;       ///< L, whether or not the options were relative
  double lengthUnit = 1.0; ///< what the options were scaled by
  SubSteps parts;          ///< of every time step
};

/**
 * L is half the diagonal of the box of samples with d <= 0; without a field or such samples, and
 * for an edge detector, of the start's box.
 * @param field may be null
 * @throws InputError for options out of range or a start without area
 */
FlowSetup setUpFlow(const SurfaceMesh& start, const ScalarImage* field, const FlowOptions& options);

} // namespace evolving

#endif
