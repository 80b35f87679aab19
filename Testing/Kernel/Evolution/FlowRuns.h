// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The flows that the tests run.
 */

#ifndef EVOLVING_FLOW_RUNS_H
#define EVOLVING_FLOW_RUNS_H

#include "Evolution/SurfaceFlow.h"

namespace evolving::flows
{

inline FlowOptions meanCurvatureFlow(double timeStep, int steps, double omega = 0.0)
{
  FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = timeStep;
  options.numberOfSteps = steps;
  options.redistribution.volume = omega;
  return options;
}

/// Towards a sphere of radius 0.5 from a bumpy one around it.
inline FlowOptions towardsSphere(int steps)
{
  FlowOptions options;
  options.timeStep = 0.05;
  options.numberOfSteps = steps;
  options.curvatureSpeed = 0.1;
  options.advectionSpeed = 1.0;
  options.redistribution.volume = 1.0;
  return options;
}

inline void run(SurfaceFlow& flow)
{
  while (!flow.isFinished())
  {
    flow.step();
  }
}

} // namespace evolving::flows

#endif
