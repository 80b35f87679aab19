// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How a time step is divided so that the explicit parts of the scheme stay stable.
 */

#ifndef EVOLVING_SUB_STEPS_H
#define EVOLVING_SUB_STEPS_H

#include "Redistribution/RedistributionOptions.h"

namespace evolving
{

/// The largest products of time step and rate with which the explicit parts behave.
struct ExplicitLimits
{
  static constexpr double Volume = 1.0; ///< 2.5 folds the mesh
  static constexpr double Angle = 0.3;  ///< of (3.24); 0.4 explodes
  static constexpr double Length = 1.0;
  static constexpr double Shape = 0.8;     ///< of the way to the best place; 1 may swing
  static constexpr double Advection = 1.0; ///< of C sqrt(1 + D^2)
};

/**
 * More parts are never made: rates that would need them are lowered to what the parts allow. By
 * then a step already lets a deviation fade by e^-32, so that nothing is lost.
 */
constexpr int MostSubSteps = 32;

struct SubSteps
{
  int count = 1;
  double timeStep = 0.0; ///< of one part
};

/// @param advectionRate C sqrt(1 + D^2); 0 without advection
SubSteps divideStep(
  double timeStep, const RedistributionOptions& redistribution, double advectionRate);

/// The rates, lowered where a sub-step of this length does not bear them.
RedistributionOptions limitRates(const RedistributionOptions& options, double subStep);

} // namespace evolving

#endif
