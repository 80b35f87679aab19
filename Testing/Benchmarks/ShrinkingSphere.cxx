// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkingSphere.h"

#include "Evolution/SurfaceFlow.h"

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace benchmark
{

namespace
{

void operator+=(Seconds& sum, const Seconds& more)
{
  sum.wall += more.wall;
  sum.cpu += more.cpu;
}

/// The inner sum of (6.1).
template <class Norm, class CoVolume>
double squaredErrors(std::size_t count, double time, const Norm& norm, const CoVolume& mu)
{
  const double r = std::sqrt(1.0 - 4.0 * time);
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double difference = norm(i) - r;
    sum += difference * difference * mu(i);
  }
  return sum;
}

void requireFinished(const evolving::SurfaceFlow& flow)
{
  if (!flow.stopReason().empty())
  {
    std::cerr << flow.stopReason() << "\n";
    std::exit(1);
  }
}

} // namespace

SphereSchedule sphereSchedule(int refinements)
{
  const double quarters = std::pow(4.0, refinements);
  return { 0.01 / quarters, static_cast<int>(6.0 * quarters) };
}

SphereRun shrinkByKernel(const evolving::SurfaceMesh& start, const SphereSchedule& schedule,
  double omega, double tolerance, int threads)
{
  evolving::FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = schedule.tau;
  options.numberOfSteps = schedule.steps;
  options.redistribution.volume = omega;
  options.solverTolerance = tolerance;
  evolving::SurfaceFlow flow(start, nullptr, options, executionOn(threads));
  SphereRun run;
  double sum = 0.0;
  while (!flow.isFinished())
  {
    const std::vector<double> mu = flow.arrays().coVolume;
    run.time += timed([&] { flow.step(); });
    run.coordinateIterations += flow.record().solverIterations;
    const auto& points = flow.mesh().points;
    sum += schedule.tau *
      squaredErrors(
        mu.size(), flow.record().time, [&](std::size_t i) { return points[i].norm(); },
        [&](std::size_t i) { return mu[i]; });
  }
  requireFinished(flow);
  run.error = std::sqrt(sum);
  return run;
}

SphereRun shrinkByThesis(const evolving::SurfaceMesh& start, const SphereSchedule& schedule,
  const TangentialForm& form, double omega, const ThesisTolerances& tolerances)
{
  ThesisScheme scheme(start, tolerances);
  if (omega > 0.0)
  {
    scheme.redistribute(form, omega);
  }
  SphereRun run;
  double sum = 0.0;
  for (int k = 1; k <= schedule.steps; ++k)
  {
    run.time += timed([&] { scheme.step(schedule.tau); });
    const auto row = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    sum += schedule.tau *
      squaredErrors(
        start.points.size(), k * schedule.tau,
        [&](std::size_t i) { return scheme.positions().row(row(i)).norm(); },
        [&](std::size_t i) { return scheme.coVolumes()[row(i)]; });
  }
  run.error = std::sqrt(sum);
  run.coordinateIterations = scheme.coordinateIterations();
  run.potentialIterations = scheme.potentialIterations();
  return run;
}

} // namespace benchmark
