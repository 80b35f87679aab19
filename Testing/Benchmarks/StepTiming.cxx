// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a step of the evolution costs: beside the thesis's scheme with sparse matrices in the run
 * of tables 6.1 to 6.3, and from mesh to mesh.
 */

#include "Arguments.h"
#include "BumpySphere.h"
#include "Report.h"
#include "ShrinkingSphere.h"
#include "Slope.h"

#include "Evolution/SurfaceFlow.h"

#include <algorithm>
#include <cmath>

using namespace benchmark;

namespace
{

constexpr double KernelTolerance = evolving::FlowOptions().solverTolerance;
/// The kernel stops there at the latest: more digits of psi would not be seen.
constexpr double PotentialTolerance = 1e-8;

/// Of a step on the finest of the meshes, with redistribution.
constexpr double LargestVertices = 163842.0;
constexpr double LargestSeconds = 0.6;

/// The kernel's right-hand side is that of the displacement, 2 tau of the position: |h| = 2.
ThesisTolerances equalTolerances(const SphereSchedule& schedule)
{
  return { KernelTolerance * 2.0 * schedule.tau, PotentialTolerance };
}

/// Runs of one scheme, measured in turn with others.
struct Measured
{
  std::string name;
  SphereRun last;
  std::vector<Seconds> times;

  void add(const SphereRun& run)
  {
    this->last = run;
    this->times.push_back(run.time);
  }
  Seconds time() const { return median(this->times); }
};

std::string verdict(bool holds)
{
  return holds ? "pass" : "FAIL";
}

void addRun(const Measured& measured, const SphereSchedule& schedule, double baseline, Table& table)
{
  const Seconds time = measured.time();
  const auto perStep = [&](long long iterations)
  { return fixed(static_cast<double>(iterations) / schedule.steps, 1); };
  const SphereRun& run = measured.last;
  table.add({ measured.name, general(run.error, 6), fixed(time.wall, 3), fixed(time.cpu, 3),
    fixed(1e3 * time.cpu / schedule.steps, 3), fixed(baseline / time.cpu, 2),
    perStep(run.coordinateIterations),
    run.potentialIterations > 0 ? perStep(run.potentialIterations) : "" });
}

void printBesideThesis(int refinements, const Arguments& arguments)
{
  const evolving::SurfaceMesh start = evolving::icosphere(refinements + 1);
  const SphereSchedule schedule = sphereSchedule(refinements);
  const auto byKernel = [&](int threads)
  { return shrinkByKernel(start, schedule, 1.0, KernelTolerance, threads); };
  Measured one{ "kernel, 1 thread", {}, {} };
  Measured all{ "kernel, " + std::to_string(arguments.threads) + " threads", {}, {} };
  Measured thesis{ "thesis, 1 thread", {}, {} };
  for (int run = 0; run < arguments.runs; ++run)
  {
    one.add(byKernel(1));
    thesis.add(shrinkByThesis(start, schedule, RightForm, 1.0, equalTolerances(schedule)));
    all.add(byKernel(arguments.threads));
  }
  Table table("Shrinking sphere, omega = 1: " + std::to_string(start.points.size()) +
      " vertices, " + std::to_string(schedule.steps) + " steps",
    { "scheme", "error", "wall s", "CPU s", "CPU ms a step", "times as fast", "iterations a step",
      "of psi" });
  const double baseline = thesis.time().cpu;
  for (const Measured* measured : { &one, &all, &thesis })
  {
    addRun(*measured, schedule, baseline, table);
  }
  const double seconds = one.time().cpu;
  table.note(
    "thesis: triplets, BiCGSTAB with a diagonal preconditioner on I + tau diag(1/mu) L, from"
    " zero; three coordinates one after another");
  table.note(
    "kernel: iterations of both systems together; residuals of equal size in both schemes");
  table.note("kernel at most 1 s: " + verdict(seconds <= 1.0) + "; at least 3 times as fast: " +
    verdict(baseline >= 3.0 * seconds) + "; errors agree to 0.5 %: " +
    verdict(std::abs(one.last.error / thesis.last.error - 1.0) <= 5e-3));
  table.print();
}

struct StepCost
{
  Seconds time;
  double iterations = 0.0;
};

evolving::FlowOptions timedOptions(const evolving::SurfaceMesh& start, double omega)
{
  evolving::FlowOptions options;
  options.relativeUnits = false;
  options.timeStep = meanCoVolume(start);
  options.redistribution.volume = omega;
  // A tenth of the surface's life, but for the coarsest.
  options.numberOfSteps = std::clamp(static_cast<int>(0.03 / options.timeStep), 4, 20);
  return options;
}

/// The mean over the steps, without the start.
StepCost costOfStep(const evolving::SurfaceMesh& start, double omega, int threads, int runs)
{
  const evolving::FlowOptions options = timedOptions(start, omega);
  const double steps = options.numberOfSteps;
  StepCost cost;
  std::vector<Seconds> measured;
  for (int run = 0; run < runs; ++run)
  {
    evolving::SurfaceFlow flow(start, nullptr, options, executionOn(threads));
    cost.iterations = 0.0;
    measured.push_back(timed(
      [&]
      {
        while (!flow.isFinished())
        {
          flow.step();
          cost.iterations += flow.record().solverIterations / steps;
        }
      }));
    measured.back().wall /= steps;
    measured.back().cpu /= steps;
  }
  cost.time = median(measured);
  return cost;
}

/// Small meshes are timed more often: their steps last less than a millisecond.
int runsFor(std::size_t vertices, int runs)
{
  return runs * std::max(1, static_cast<int>(20000 / vertices));
}

void printGrowth(double omega, const Arguments& arguments)
{
  const std::string threads = std::to_string(arguments.threads) + " threads: ";
  Table table("A step on a bumpy sphere, tau the mean co-volume, omega = " + general(omega),
    { "vertices", "1 thread: wall ms", "CPU ms", "us a vertex", "exponent", threads + "wall ms",
      "CPU ms", "iterations" });
  std::vector<double> counts;
  std::vector<double> times;
  for (const int size : arguments.sizes)
  {
    const evolving::SurfaceMesh start = bumpySphere(levelOfVertices(size));
    const auto vertices = static_cast<double>(start.points.size());
    const int runs = runsFor(start.points.size(), arguments.runs);
    const StepCost one = costOfStep(start, omega, 1, runs);
    const StepCost all = costOfStep(start, omega, arguments.threads, runs);
    counts.push_back(vertices);
    times.push_back(one.time.cpu);
    const std::size_t n = counts.size();
    const std::string exponent = n < 2
      ? ""
      : fixed(exponentOf({ counts[n - 2], counts[n - 1] }, { times[n - 2], times[n - 1] }), 2);
    table.add({ fixed(vertices, 0), fixed(1e3 * one.time.wall, 3), fixed(1e3 * one.time.cpu, 3),
      fixed(1e6 * one.time.cpu / vertices, 3), exponent, fixed(1e3 * all.time.wall, 3),
      fixed(1e3 * all.time.cpu, 3), fixed(one.iterations, 1) });
  }
  if (counts.size() > 1)
  {
    const double exponent = exponentOf(counts, times);
    table.note("processor time of one thread grows like vertices^" + fixed(exponent, 2) +
      ", wanted at most 1.2: " + verdict(exponent <= 1.2));
  }
  if (counts.back() == LargestVertices)
  {
    table.note("the last in less than " + general(LargestSeconds) +
      " s of one thread: " + verdict(times.back() < LargestSeconds));
  }
  table.print();
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 642, 2562, 10242, 40962, 163842 };
  const Arguments arguments = readArguments(argc, argv, defaults,
    "The time of a step of the evolution: the 2562-vertex run of the thesis's table 6.2 beside the"
    " thesis's scheme, and over icospheres of --sizes vertices.");
  printHeader("StepTiming", arguments);
  constexpr int FinestRow = 3; // of the thesis's tables
  const int largest = *std::max_element(arguments.sizes.begin(), arguments.sizes.end());
  printBesideThesis(std::clamp(levelOfVertices(largest) - 1, 0, FinestRow), arguments);
  printGrowth(0.0, arguments);
  printGrowth(1.0, arguments);
  return 0;
}
