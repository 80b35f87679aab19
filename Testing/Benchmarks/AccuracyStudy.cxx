// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far Method ClosestPoint is from BruteForce, in cells, and whether the sign methods agree,
 * on every mesh given.
 */

#include "Arguments.h"
#include "Models.h"
#include "Report.h"
#include "SampledDistance.h"
#include "Timing.h"

#include "Distance/DistanceTarget.h"

#include <algorithm>

using namespace benchmark;

namespace
{

bool isClosed(const Model& model)
{
  if (model.triangles() == 0)
  {
    return false;
  }
  const evolving::DistanceTarget target = evolving::makeDistanceTarget(kernelMesh(model.surface));
  return target.orientation.isClosed() && target.orientation.isOriented();
}

/// How many samples FloodFill and Pseudonormal call differently, all counted.
std::string floodFillDifferences(const Model& model, int size, int threads)
{
  if (!isClosed(model))
  {
    return "not closed";
  }
  Sampling sampling{ size, vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::FLOOD_FILL, threads };
  const auto flooded = values(sampleDistance(model.surface, sampling));
  sampling.sign = vtkMeshSDF::PSEUDONORMAL;
  const auto normals = values(sampleDistance(model.surface, sampling));
  long long count = 0;
  for (std::size_t s = 0; s < flooded.size(); ++s)
  {
    count += (flooded[s] < 0.0F) != (normals[s] < 0.0F) ? 1 : 0;
  }
  return std::to_string(count);
}

struct Worst
{
  double mean = 0.0;
  double largest = 0.0;
  long long signs = 0;
};

void addModel(const Model& model, int size, int threads, Table& table, Worst& worst)
{
  Sampling sampling{ size, vtkMeshSDF::BRUTE_FORCE, vtkMeshSDF::AUTOMATIC, threads };
  const auto exact = sampleDistance(model.surface, sampling);
  sampling.method = vtkMeshSDF::CLOSEST_POINT;
  const auto image = sampleDistance(model.surface, sampling);
  const Difference error = difference(values(image), values(exact), image->GetSpacing()[0]);
  table.add({ model.name, std::to_string(model.triangles()), signMethod(image), general(error.mean),
    general(error.largest), std::to_string(error.signs),
    floodFillDifferences(model, size, threads) });
  worst.mean = std::max(worst.mean, error.mean);
  worst.largest = std::max(worst.largest, error.largest);
  worst.signs += error.signs;
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 128 };
  defaults.runs = 1;
  const Arguments arguments = readArguments(argc, argv, defaults,
    "Error of ClosestPoint against BruteForce and agreement of signs, on every mesh as it is.");
  printHeader("AccuracyStudy", arguments);
  for (const int size : arguments.sizes)
  {
    Table table("ClosestPoint against BruteForce at " + cube(size) + " (Sign Automatic), in cells",
      { "mesh", "faces", "sign", "mean error", "largest error", "signs differ",
        "FloodFill / Pseudonormal differ" });
    Worst worst;
    for (const std::string& path : arguments.models)
    {
      addModel(readModel(path), size, arguments.threads, table, worst);
    }
    table.add({ "worst", "", "", general(worst.mean), general(worst.largest),
      std::to_string(worst.signs) });
    table.note("'signs differ': samples farther than 1e-4 cells from the surface, of " +
      std::to_string(static_cast<long long>(size) * size * size) + ". The last column counts all.");
    table.print();
  }
  return 0;
}
