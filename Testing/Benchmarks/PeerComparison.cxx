// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * vtkMeshSDF beside the programs that do the same: OpenVDB's meshToVolume on the same grid and
 * vtkImplicitPolyDataDistance, in one run, so that whatever else the machine does slows all.
 */

#include "Arguments.h"
#include "Models.h"
#include "OpenVDBPeer.h"
#include "Report.h"
#include "SampledDistance.h"
#include "Timing.h"

#include "vtkImplicitPolyDataDistance.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

using namespace benchmark;

namespace
{

constexpr int ImplicitGrid = 128; ///< on which vtkImplicitPolyDataDistance is extrapolated
constexpr int ImplicitPoints = 2000;
constexpr float NarrowBand = 3.0F;

const char* const NoOpenVDB = "not available (install libopenvdb-dev)";

/// Its field in cells, all of it or what lies in a band.
struct Outcome
{
  std::vector<float> distance;
  std::vector<char> inBand; ///< empty: everywhere
};

struct Contestant
{
  std::string name;
  std::function<void()> run;
  std::function<Outcome()> lastOutcome;
  Outcome outcome;
  std::vector<Seconds> times;

  void measure()
  {
    this->times.push_back(timed(this->run));
    this->outcome = this->lastOutcome();
  }
};

/// One of the methods of vtkMeshSDF.
Contestant ours(const std::string& name, const Model& model, const Sampling& sampling)
{
  auto image = std::make_shared<vtkSmartPointer<vtkImageData>>();
  return { name, [=] { *image = sampleDistance(model.surface, sampling); },
    [=]
    {
      Outcome outcome{ values(*image), {} };
      for (float& distance : outcome.distance)
      {
        distance = static_cast<float>(static_cast<double>(distance) / (*image)->GetSpacing()[0]);
      }
      return outcome;
    },
    {}, {} };
}

Contestant openVDB(const std::string& name, const std::shared_ptr<OpenVDBPeer>& peer, float band)
{
  return { name, [=] { peer->convert(band); },
    [=]
    {
      const OpenVDBPeer::Field field = peer->field();
      return Outcome{ field.distance, field.inBand };
    },
    {}, {} };
}

/// Errors in the band only; signs everywhere, for they are told everywhere.
std::vector<std::string> accuracy(const Outcome& outcome, const std::vector<float>& exact)
{
  std::vector<float> found;
  std::vector<float> expected;
  for (std::size_t s = 0; s < exact.size(); ++s)
  {
    if (outcome.inBand.empty() || outcome.inBand[s])
    {
      found.push_back(outcome.distance[s]);
      expected.push_back(exact[s]);
    }
  }
  const Difference inBand = difference(found, expected, 1.0);
  const Difference everywhere = difference(outcome.distance, exact, 1.0);
  const double covered = static_cast<double>(found.size()) / static_cast<double>(exact.size());
  return { fixed(100.0 * covered, 1) + " %", general(inBand.mean), general(inBand.largest),
    std::to_string(everywhere.signs) };
}

std::vector<Contestant> contestants(const Model& model, int size, int threads)
{
  std::vector<Contestant> all;
  all.push_back(ours("vtkMeshSDF ClosestPoint", model,
    { size, vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::AUTOMATIC, threads }));
  all.push_back(ours("vtkMeshSDF FastSweeping, FloodFill", model,
    { size, vtkMeshSDF::FAST_SWEEPING, vtkMeshSDF::FLOOD_FILL, threads }));
  if (!OpenVDBPeer::version().empty())
  {
    const auto image = sampleDistance(
      model.surface, { size, vtkMeshSDF::FAST_SWEEPING, vtkMeshSDF::UNSIGNED, threads });
    const auto peer = std::make_shared<OpenVDBPeer>(model.surface, image, threads);
    all.push_back(openVDB("OpenVDB, band of half the grid", peer, 0.5F * static_cast<float>(size)));
    all.push_back(openVDB("OpenVDB, band of 3 cells", peer, NarrowBand));
  }
  return all;
}

void printGrid(const Model& model, int size, const Arguments& arguments)
{
  Table table("Whole signed grid of " + cube(size) + ", " + std::to_string(arguments.threads) +
      " threads: " + model.name,
    { "method", "seconds", "processor time", "to ClosestPoint", "samples", "mean error, cells",
      "largest", "signs differ" });
  std::vector<Contestant> all = contestants(model, size, arguments.threads);
  for (int run = 0; run < arguments.runs; ++run)
  {
    for (Contestant& one : all)
    {
      one.measure();
    }
  }
  Contestant reference = ours("vtkMeshSDF BruteForce, once", model,
    { size, vtkMeshSDF::BRUTE_FORCE, vtkMeshSDF::AUTOMATIC, arguments.threads });
  reference.measure();
  all.push_back(reference);
  const double first = median(all.front().times).wall;
  for (const Contestant& one : all)
  {
    const Seconds time = median(one.times);
    std::vector<std::string> row{ one.name, fixed(time.wall, 3), fixed(time.cpu, 3),
      fixed(time.wall / first, 2) };
    const std::vector<std::string> errors = accuracy(one.outcome, reference.outcome.distance);
    row.insert(row.end(), errors.begin(), errors.end());
    table.add(row);
  }
  const std::string version = OpenVDBPeer::version();
  if (version.empty())
  {
    table.add({ "OpenVDB", NoOpenVDB });
  }
  table.note("Errors against BruteForce, in the band only; signs on the whole grid, farther than"
             " 1e-4 cells from the surface.");
  if (!version.empty())
  {
    table.note(version +
      ": meshToVolume in index space, its mesh converted before the clock"
      " starts, TBB's threads limited.");
  }
  table.print();
}

/// Seconds for a cube grid, from its locator and a sample of points.
Seconds implicitDistance(vtkPolyData* surface, vtkImageData* grid, int runs)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<vtkIdType> anySample(0, grid->GetNumberOfPoints() - 1);
  std::vector<vtkIdType> samples(ImplicitPoints);
  std::generate(samples.begin(), samples.end(), [&] { return anySample(random); });
  double sum = 0.0;
  vtkSmartPointer<vtkImplicitPolyDataDistance> implicit;
  const Seconds prepare = medianOf(runs,
    [&]
    {
      implicit = vtkSmartPointer<vtkImplicitPolyDataDistance>::New();
      implicit->SetInput(surface);
    });
  const Seconds evaluate = medianOf(runs,
    [&]
    {
      for (const vtkIdType sample : samples)
      {
        double point[3];
        grid->GetPoint(sample, point);
        sum += implicit->EvaluateFunction(point);
      }
    });
  const double factor = static_cast<double>(grid->GetNumberOfPoints()) / ImplicitPoints;
  return { prepare.wall + factor * evaluate.wall, prepare.cpu + factor * evaluate.cpu };
}

void printImplicit(const Model& model, const Arguments& arguments)
{
  Table table("Whole signed grid of " + cube(ImplicitGrid) + ": " + model.name,
    { "method", "threads", "seconds", "to ClosestPoint on as many threads" });
  vtkSmartPointer<vtkImageData> image;
  const auto closestPoint = [&](int threads)
  {
    const Sampling sampling{ ImplicitGrid, vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::AUTOMATIC,
      threads };
    return medianOf(arguments.runs, [&] { image = sampleDistance(model.surface, sampling); });
  };
  const Seconds serial = closestPoint(1);
  const Seconds threaded = closestPoint(arguments.threads);
  const Seconds implicit = implicitDistance(model.surface, image, arguments.runs);
  table.add({ "vtkMeshSDF ClosestPoint", "1", fixed(serial.wall, 3), "1" });
  table.add(
    { "vtkMeshSDF ClosestPoint", std::to_string(arguments.threads), fixed(threaded.wall, 3), "1" });
  table.add({ "vtkImplicitPolyDataDistance, extrapolated", "1", fixed(implicit.wall, 1),
    fixed(implicit.wall / serial.wall, 0) });
  table.note("vtkImplicitPolyDataDistance was timed on " + std::to_string(ImplicitPoints) +
    " samples of the grid drawn at random and has no threads of its own.");
  table.print();
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 256 };
  const Arguments arguments = readArguments(
    argc, argv, defaults, "vtkMeshSDF beside OpenVDB and vtkImplicitPolyDataDistance.");
  printHeader("PeerComparison", arguments);
  for (const std::string& path : arguments.models)
  {
    const Model scan = readScan(path, arguments.subdivisions);
    for (const int size : arguments.sizes)
    {
      printGrid(scan, size, arguments);
    }
    printImplicit(scan, arguments);
  }
  return 0;
}
