// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What is known at the vertices of a surface in a state of its evolution or redistribution.
 */

#ifndef EVOLVING_STATE_ARRAYS_H
#define EVOLVING_STATE_ARRAYS_H

#include "Types.h"

#include <vector>

namespace evolving
{

/// One value per vertex (or 3), as they were used to compute the step *after* the state.
struct StateArrays
{
  std::vector<double> distance;       ///< the field's value; empty without a field
  std::vector<Vec3> distanceGradient; ///< normalized; empty without a field
  std::vector<Vec3> normal;
  std::vector<double> meanCurvature; ///< -h.N: +2/r on a sphere
  std::vector<double> coVolume;
  std::vector<double> normalVelocity; ///< epsilon h.N + eta
  std::vector<Vec3> tangentialVelocity;
  std::vector<double> redistributionPotential; ///< psi
};

} // namespace evolving

#endif
