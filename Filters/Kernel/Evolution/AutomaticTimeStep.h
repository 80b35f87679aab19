// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A time step for who has not chosen one.
 */

#ifndef EVOLVING_AUTOMATIC_TIME_STEP_H
#define EVOLVING_AUTOMATIC_TIME_STEP_H

#include "Evolution/FlowOptions.h"
#include "Evolution/ScalarImage.h"
#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * The step with which options.numberOfSteps steps lead as far as a user wants to see.
 *
 * - Without a field: timeOfVisibleChange() in all, so that the step grows with the square of
 * lengths; where the volume is held, until all is balls (RelaxationTime.h), but for a thousandth.
 * - Distance field: the advection leaves exp(-C T) of a distance, and where curvature holds
 *   against it about exp(-C T / 2); a thousandth there in all, which no eye sees.
 * - Edge detector: twice timeOfVisibleChange(), the life of the start, for curvature alone leads a
 *   surface to edges far away; with a normal speed, a cell a step, which is the most
 * (ControlField).
 *
 * Where the term that counts is off, the other one's time; where both are, any.
 *
 * @param field may be null
 * @param options in absolute units
 * @param size L
 * @return above 0
 * @throws InputError as MeshTopology
 */
double automaticTimeStep(
  const SurfaceMesh& start, const ScalarImage* field, const FlowOptions& options, double size);

} // namespace evolving

#endif
