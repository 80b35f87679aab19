// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where the time goes, over resolutions, as section 5.4 of the thesis measures it: the phases of
 * the methods in the kernel, and vtkMeshSDF as users get it.
 */

#include "Arguments.h"
#include "Models.h"
#include "Report.h"
#include "SampledDistance.h"
#include "SweepingParts.h"
#include "Timing.h"

#include "Distance/ClosestPoint/ClosestOnGrid.h"
#include "Distance/ClosestPoint/OrientedBoxTree.h"
#include "Distance/ClosestTriangles.h"
#include "Distance/DistanceTarget.h"
#include "Distance/Signs/InsideOutside.h"
#include "Trees/AABBTree.h"

#include <limits>
#include <memory>
#include <optional>

using namespace benchmark;
using evolving::AABBTree;
using evolving::DistanceGrid;
using evolving::DistanceMethod;
using evolving::DistanceOctree;
using evolving::DistanceTarget;
using evolving::Execution;
using evolving::SignMethod;
using evolving::SurfaceMesh;

namespace
{

/// BruteForce asks the tree for every sample; on larger grids that is minutes.
constexpr int LargestBruteForce = 128;
constexpr int AnySize = std::numeric_limits<int>::max();

std::string seconds(const Seconds& time)
{
  return fixed(time.wall, 3);
}

/// One model on one grid with so many threads.
class Measurement
{
public:
  Measurement(const Model& model, const SurfaceMesh& mesh, int size, int threads, int runs)
    : Input(model)
    , Mesh(mesh)
    , Size(size)
    , Threads(threads)
    , Runs(runs)
    , Host(executionOn(threads))
  {
    this->Prepare = this->median([&] { this->Target = evolving::makeDistanceTarget(this->Mesh); });
    this->BuildTree = this->median([&] { this->Tree.emplace(this->Target.mesh, this->Host); });
    this->Grid = cubeGrid(this->Mesh, this->Size);
    this->Grid.origin -= this->Target.center;
  }

  std::vector<std::string> sweepingRow() const
  {
    std::unique_ptr<DistanceOctree> octree;
    const Seconds open = this->median(
      [&] { octree = std::make_unique<DistanceOctree>(*this->Tree, this->Grid, this->Host); });
    const Seconds freeze = this->median([&] { frozenField(*octree, this->Grid); });
    const Seconds sweeps = this->medianOfSweeps(*octree);
    const SignedTotal total = this->floodFill();
    return { cube(this->Size), std::to_string(this->Threads), seconds(this->Prepare),
      seconds(this->BuildTree), seconds(open), seconds(freeze), seconds(sweeps),
      fixed(total.sign, 3), fixed(total.total, 3),
      seconds(this->filter(vtkMeshSDF::FAST_SWEEPING, vtkMeshSDF::FLOOD_FILL)) };
  }

  std::vector<std::string> closestPointRow() const
  {
    evolving::SignChoice sign;
    const Seconds choose = this->median(
      [&] { sign = evolving::chooseSignMethod(SignMethod::Automatic, this->Target, this->Host); });
    // The search has a tree of its own; in which unit it is built does not matter here.
    const std::vector<evolving::Triangle> triangles = evolving::trianglesOf(this->Target.mesh);
    const Seconds boxes = this->median(
      [&] { evolving::OrientedBoxTree(triangles, 1e-6 * this->Grid.spacing.x(), this->Host); });
    evolving::GridClosest closest;
    const Seconds search = this->median(
      [&]
      {
        closest = evolving::closestOnGrid(
          this->Target.mesh, this->Grid, std::numeric_limits<double>::infinity(), this->Host);
      });
    const evolving::UnsignedDistance samples{ std::move(closest.distance),
      std::move(closest.triangle), {} };
    const Seconds sides = this->median(
      [&] { evolving::samplesInside(sign.method, this->Target, this->Grid, samples, this->Host); });
    const Seconds total = this->kernel(DistanceMethod::ClosestPoint, SignMethod::Automatic);
    const Seconds filtered = this->filter(vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::AUTOMATIC);
    return { cube(this->Size), std::to_string(this->Threads), seconds(this->Prepare),
      seconds(choose), seconds(boxes), fixed(search.wall - boxes.wall, 3), seconds(sides),
      seconds(total), fixed(total.cpu, 3), seconds(filtered), fixed(filtered.cpu, 3) };
  }

  std::vector<std::string> bruteForceRow() const
  {
    const Seconds search =
      this->median([&] { evolving::queryClosestTriangles(*this->Tree, this->Grid, this->Host); });
    const Seconds total = this->kernel(DistanceMethod::BruteForce, SignMethod::Automatic);
    return { cube(this->Size), std::to_string(this->Threads), seconds(this->Prepare),
      seconds(this->BuildTree), seconds(search), seconds(total),
      seconds(this->filter(vtkMeshSDF::BRUTE_FORCE, vtkMeshSDF::AUTOMATIC)) };
  }

  std::vector<std::string> sweepCostRow() const
  {
    const DistanceOctree octree(*this->Tree, this->Grid, this->Host);
    const Seconds sweeps = this->medianOfSweeps(octree);
    const double nanoseconds = 1e9 / (8.0 * static_cast<double>(this->Grid.sampleCount()));
    return { cube(this->Size), fixed(nanoseconds * sweeps.wall, 2),
      fixed(nanoseconds * sweeps.cpu, 2) };
  }

private:
  struct SignedTotal
  {
    double total = 0.0;
    double sign = 0.0;
  };

  /// The sign is what a total with it takes more than one without it; the two run in turn, so
  /// that the machine's load is the same for both.
  SignedTotal floodFill() const
  {
    std::vector<Seconds> totals;
    std::vector<Seconds> signs;
    for (int run = 0; run < this->Runs; ++run)
    {
      const Seconds with = this->kernelOnce(DistanceMethod::FastSweeping, SignMethod::FloodFill);
      const Seconds without = this->kernelOnce(DistanceMethod::FastSweeping, SignMethod::Unsigned);
      totals.push_back(with);
      signs.push_back({ with.wall - without.wall, with.cpu - without.cpu });
    }
    return { benchmark::median(totals).wall, benchmark::median(signs).wall };
  }

  Seconds median(const std::function<void()>& work) const { return medianOf(this->Runs, work); }

  Seconds medianOfSweeps(const DistanceOctree& octree) const
  {
    std::vector<Seconds> measured;
    for (int run = 0; run < this->Runs; ++run)
    {
      evolving::SweptField field = frozenField(octree, this->Grid);
      measured.push_back(timed([&] { evolving::sweep(field, 8, this->Host); }));
    }
    return benchmark::median(measured);
  }

  Seconds kernelOnce(DistanceMethod method, SignMethod sign) const
  {
    return timed([&] { wholeDistance(this->Mesh, this->Size, method, sign, this->Host); });
  }

  Seconds kernel(DistanceMethod method, SignMethod sign) const
  {
    return this->median([&] { wholeDistance(this->Mesh, this->Size, method, sign, this->Host); });
  }

  Seconds filter(int method, int sign) const
  {
    const Sampling sampling{ this->Size, method, sign, this->Threads };
    return this->median([&] { sampleDistance(this->Input.surface, sampling); });
  }

  const Model& Input;
  const SurfaceMesh& Mesh;
  int Size;
  int Threads;
  int Runs;
  Execution Host;
  DistanceGrid Grid; ///< relative to the target's centre
  DistanceTarget Target;
  std::optional<AABBTree> Tree;
  Seconds Prepare;
  Seconds BuildTree;
};

std::vector<int> threadCounts(const Arguments& arguments)
{
  return arguments.threads > 1 ? std::vector<int>{ 1, arguments.threads } : std::vector<int>{ 1 };
}

using Row = std::vector<std::string> (Measurement::*)() const;

/// A row per grid and number of threads.
void addRows(const Model& model, const Arguments& arguments, int largest, Row row, Table& table)
{
  const SurfaceMesh mesh = kernelMesh(model.surface);
  for (const int size : arguments.sizes)
  {
    for (const int threads : threadCounts(arguments))
    {
      if (size <= largest)
      {
        table.add((Measurement(model, mesh, size, threads, arguments.runs).*row)());
      }
    }
  }
}

void printSweeping(const Model& model, const Arguments& arguments)
{
  Table table("FastSweeping with FloodFill, seconds: " + model.name,
    { "grid", "threads", "prepare", "tree", "octree", "freeze", "8 sweeps", "sign", "total",
      "vtkMeshSDF" });
  table.add({ "thesis 150^3", "1", "", "0.32", "0.14", "", "0.33", "1.17", "1.96" });
  addRows(model, arguments, AnySize, &Measurement::sweepingRow, table);
  table.note("'thesis': its author's log for a bunny of 69 thousand triangles, on his machine of"
             " 2020. 'octree' finds the leaves and their");
  table.note(
    "exact distances; 'sign' is the total with a sign less the total without one, run in turn.");
  table.print();
}

void printClosestPoint(const Model& model, const Arguments& arguments)
{
  Table table("ClosestPoint with Sign Automatic, seconds: " + model.name,
    { "grid", "threads", "prepare", "choose sign", "boxes", "search", "sign", "total",
      "its processor time", "vtkMeshSDF", "its processor time" });
  addRows(model, arguments, AnySize, &Measurement::closestPointRow, table);
  table.note("'choose sign' looks for self-intersections, 'boxes' is the tree of oriented boxes.");
  table.print();
}

void printBruteForce(const Model& model, const Arguments& arguments)
{
  Table table("BruteForce with Sign Automatic, seconds: " + model.name,
    { "grid", "threads", "prepare", "tree", "closest triangles", "total", "vtkMeshSDF" });
  Arguments once = arguments; // it is the reference, not what users wait for
  once.runs = 1;
  addRows(model, once, LargestBruteForce, &Measurement::bruteForceRow, table);
  table.note("One run each, up to " + cube(LargestBruteForce) + ".");
  table.print();
}

void printSweepCost(const Model& model, const Arguments& arguments)
{
  Table table("One sweep on one thread, ns a sample: " + model.name,
    { "grid", "by the clock", "processor time" });
  table.add({ "author 2020", "12.1" });
  Arguments serial = arguments;
  serial.threads = 1;
  addRows(model, serial, AnySize, &Measurement::sweepCostRow, table);
  table.note("wanted: at most 10");
  table.print();
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 64, 128, 150, 256 };
  const Arguments arguments = readArguments(
    argc, argv, defaults, "The time of each phase of the distance methods over resolutions.");
  printHeader("TimingStudy", arguments);
  for (const std::string& path : arguments.models)
  {
    const Model scan = readScan(path, arguments.subdivisions);
    printSweepCost(scan, arguments);
    printSweeping(scan, arguments);
    printClosestPoint(scan, arguments);
    printBruteForce(scan, arguments);
  }
  return 0;
}
