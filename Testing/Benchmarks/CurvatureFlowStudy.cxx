// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The flows of the field against what is known of them: Angenent's torus, and the rates at which a
 * mode of degree 2 on a sphere fades; with the time of a step.
 */

#include "Arguments.h"
#include "Report.h"

#include "Evolution/SurfaceFlow.h"
#include "Shapes/SelfSimilarTorus.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace benchmark;
using namespace evolving;

namespace
{

FlowOptions flowOf(double time, int steps)
{
  FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = time / steps;
  options.numberOfSteps = steps;
  return options;
}

struct Run
{
  double error = 0.0;
  double secondsOfStep = 0.0;
  int iterations = 0; ///< of the last step
  double volumeDrift = 0.0;
};

/// Steps to the end; the error is left to the caller.
Run run(SurfaceFlow& flow)
{
  Run result;
  const double volume = flow.record().volume;
  while (!flow.isFinished())
  {
    flow.step();
    result.secondsOfStep += flow.record().seconds / flow.totalSteps();
    result.iterations = flow.record().solverIterations;
    result.volumeDrift =
      std::max(result.volumeDrift, std::abs(flow.record().volume / volume - 1.0));
  }
  return result;
}

std::string orderOf(double coarser, double error)
{
  return coarser > 0.0 ? fixed(std::log2(coarser / error), 2) : "";
}

/// Root mean square distance from the exact torus at t = 0.3; it is unstable, so not later.
void printTorus(const std::vector<int>& rings)
{
  constexpr double Time = 0.3;
  const shapes::SelfSimilarTorus torus;
  Table table("Angenent's torus under mean curvature flow, t = 0.3",
    { "rings", "points", "steps", "rms error", "order", "ms a step" }, 0);
  double coarser = 0.0;
  for (const int count : rings)
  {
    const int steps = std::max(1, 20 * count * count / 64);
    SurfaceFlow flow(torus.mesh(count, 2 * count), nullptr, flowOf(Time, steps));
    Run result = run(flow);
    for (Index i = 0; i < flow.mesh().vertexCount(); ++i)
    {
      const double distance = torus.distance(flow.mesh().points[at(i)], Time);
      result.error += flow.arrays().coVolume[at(i)] * distance * distance;
    }
    result.error = std::sqrt(result.error / flow.record().area);
    table.add({ std::to_string(count), std::to_string(flow.mesh().vertexCount()),
      std::to_string(steps), general(result.error), orderOf(coarser, result.error),
      fixed(1e3 * result.secondsOfStep, 2) });
    coarser = result.error;
  }
  table.print();
}

/// Of 0.5 (3 z^2 - 1) in |F|.
double amplitudeOf(const SurfaceFlow& flow)
{
  double product = 0.0;
  double square = 0.0;
  for (Index i = 0; i < flow.mesh().vertexCount(); ++i)
  {
    const Vec3& p = flow.mesh().points[at(i)];
    const double z = p.normalized().z();
    const double mode = 0.5 * (3.0 * z * z - 1.0);
    product += flow.arrays().coVolume[at(i)] * mode * (p.norm() - 1.0);
    square += flow.arrays().coVolume[at(i)] * mode * mode;
  }
  return product / square;
}

/// @param rate at which it fades exactly
void printMode(const std::string& title, const FlowOptions& kind, double rate, int finest)
{
  Table table(title,
    { "points", "steps", "error of the rate", "order", "volume drift", "iterations", "ms a step" },
    0);
  double coarser = 0.0;
  for (int level = 2; level <= finest; ++level)
  {
    SurfaceMesh start = icosphere(level);
    for (Vec3& p : start.points)
    {
      p *= 1.0 + 1e-3 * 0.5 * (3.0 * p.z() * p.z() - 1.0);
    }
    FlowOptions options = flowOf(1.0 / rate, 4 << (2 * (level - 2)));
    options.flow = kind.flow;
    options.volumePreserving = kind.volumePreserving;
    SurfaceFlow flow(start, nullptr, options);
    const double before = amplitudeOf(flow);
    Run result = run(flow);
    result.error = std::abs(std::log(before / amplitudeOf(flow)) - 1.0);
    table.add({ std::to_string(start.vertexCount()), std::to_string(options.numberOfSteps),
      general(result.error), orderOf(coarser, result.error), general(result.volumeDrift),
      std::to_string(result.iterations), fixed(1e3 * result.secondsOfStep, 2) });
    coarser = result.error;
  }
  table.print();
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 8, 16, 32, 64 };
  const Arguments arguments = readArguments(argc, argv, defaults,
    "Errors and orders of the flows: Angenent's torus with --sizes rings, modes on spheres.");
  printHeader("CurvatureFlowStudy", arguments);
  printTorus(arguments.sizes);
  // As fine as the torus: its 64 rings have about as many points as level 5.
  const int finest = std::clamp(static_cast<int>(std::log2(arguments.sizes.back())) - 1, 3, 6);
  FlowOptions kind;
  kind.volumePreserving = true;
  printMode("Volume-preserving mean curvature flow, a mode of degree 2", kind, 4.0, finest);
  kind.flow = Flow::SurfaceDiffusion;
  printMode("Surface diffusion, a mode of degree 2", kind, 24.0, finest);
  return 0;
}
