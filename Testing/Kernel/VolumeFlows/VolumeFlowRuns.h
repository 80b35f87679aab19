// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Flows that hold the volume, as the tests run them.
 */

#ifndef EVOLVING_VOLUME_FLOW_RUNS_H
#define EVOLVING_VOLUME_FLOW_RUNS_H

#include "Evolution/SurfaceFlow.h"
#include "Evolution/SurfaceRemesher.h"
#include "Mesh/Angles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace evolving::flows
{

/// With an automatic time step where none is given.
inline FlowOptions volumePreserving(int steps, double timeStep = 0.0)
{
  FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = timeStep;
  options.numberOfSteps = steps;
  options.volumePreserving = true;
  return options;
}

inline FlowOptions surfaceDiffusion(int steps, double timeStep = 0.0)
{
  FlowOptions options = volumePreserving(steps, timeStep);
  options.volumePreserving = false;
  options.flow = Flow::SurfaceDiffusion;
  return options;
}

/// New elements where they degenerate, as the filter has them by default.
inline SurfaceFlow remeshed(const SurfaceMesh& start, const FlowOptions& options)
{
  SurfaceRemeshingOptions remeshing;
  remeshing.onlyDegenerate = true;
  remeshing.boundaryMode = options.boundaryMode;
  return SurfaceFlow(std::make_shared<const SurfaceMesh>(start), nullptr,
    std::make_shared<SurfaceRemesher>(start, remeshing), options);
}

/// The least and the largest distance from a point.
struct Radii
{
  double least = 1e300;
  double largest = 0.0;
};

inline Radii radiiOf(const SurfaceMesh& mesh, const Vec3& center = Vec3::Zero())
{
  Radii radii;
  for (const Vec3& p : mesh.points)
  {
    radii.least = std::min(radii.least, (p - center).norm());
    radii.largest = std::max(radii.largest, (p - center).norm());
  }
  return radii;
}

inline double radiusOfBall(double volume)
{
  return std::cbrt(0.75 * volume / Pi);
}

/// What must hold in every step: the volume to rounding, and an area that falls.
struct Ledger
{
  double volumeDrift = 0.0; ///< the largest, of the start's volume
  double areaGrowth = -1.0; ///< the largest in a step, of its area; below 0 where it falls
};

inline Ledger runWithLedger(SurfaceFlow& flow)
{
  Ledger ledger;
  const double volume = flow.record().volume;
  double area = flow.record().area;
  while (!flow.isFinished())
  {
    flow.step();
    EXPECT_EQ(flow.stopReason(), "");
    ledger.volumeDrift =
      std::max(ledger.volumeDrift, std::abs(flow.record().volume / volume - 1.0));
    ledger.areaGrowth = std::max(ledger.areaGrowth, flow.record().area / area - 1.0);
    area = flow.record().area;
  }
  return ledger;
}

} // namespace evolving::flows

#endif
