// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How the time of vtkMeshSDF grows with the samples (a + b * samples) and with the triangles of
 * the surface.
 */

#include "Arguments.h"
#include "Models.h"
#include "Report.h"
#include "SampledDistance.h"
#include "Slope.h"
#include "Timing.h"

#include "Distance/DistanceTarget.h"

#include <cmath>

using namespace benchmark;

namespace
{

constexpr int TriangleGrid = 128;
constexpr int FinestSubdivision = 3;

double samples(int size)
{
  return std::pow(static_cast<double>(size), 3.0);
}

void printSamples(const Model& model, const Arguments& arguments)
{
  Table table("vtkMeshSDF over samples, default parameters, " + std::to_string(arguments.threads) +
      " threads: " + model.name,
    { "grid", "seconds", "processor time", "ns a sample", "b from the last two, ns",
      "ratio to the b before" });
  std::vector<double> counts;
  std::vector<double> times;
  double lastGrowth = 0.0;
  for (const int size : arguments.sizes)
  {
    const Sampling sampling{ size, vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::AUTOMATIC,
      arguments.threads };
    const Seconds time = medianOf(arguments.runs, [&] { sampleDistance(model.surface, sampling); });
    std::vector<std::string> row{ cube(size), fixed(time.wall, 3), fixed(time.cpu, 3),
      fixed(1e9 * time.wall / samples(size), 1) };
    if (!counts.empty())
    {
      const double growth = (time.wall - times.back()) / (samples(size) - counts.back());
      row.push_back(fixed(1e9 * growth, 2));
      row.push_back(lastGrowth > 0.0 ? fixed(growth / lastGrowth, 2) : "");
      lastGrowth = growth;
    }
    counts.push_back(samples(size));
    times.push_back(time.wall);
    table.add(row);
  }
  if (counts.size() > 1)
  {
    const Line line = lineThrough(counts, times);
    table.note("time = a + b * samples: a = " + fixed(line.start, 3) +
      " s, b = " + fixed(1e9 * line.slope, 2) + " ns");
  }
  table.print();
}

/// @return the time of vtkMeshSDF
double addTriangles(const Model& model, const Arguments& arguments, Table& table)
{
  const evolving::SurfaceMesh mesh = kernelMesh(model.surface);
  const Seconds prepare = medianOf(arguments.runs, [&] { evolving::makeDistanceTarget(mesh); });
  const Sampling sampling{ TriangleGrid, vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::AUTOMATIC,
    arguments.threads };
  vtkSmartPointer<vtkImageData> image;
  const Seconds time =
    medianOf(arguments.runs, [&] { image = sampleDistance(model.surface, sampling); });
  table.add({ model.name, std::to_string(model.triangles()), signMethod(image),
    fixed(prepare.wall, 3), fixed(time.wall, 3), fixed(time.cpu, 3),
    fixed(1e6 * time.wall / static_cast<double>(model.triangles()), 2) });
  return time.wall;
}

/// The first model at several subdivisions, the others as they are.
void printTriangles(const Arguments& arguments)
{
  Table table("vtkMeshSDF over triangles at " + cube(TriangleGrid) + ", default parameters, " +
      std::to_string(arguments.threads) + " threads",
    { "mesh", "triangles", "sign", "prepare", "seconds", "processor time", "us a triangle" });
  std::vector<double> counts;
  std::vector<double> times;
  for (int subdivisions = 0; subdivisions <= FinestSubdivision; ++subdivisions)
  {
    const Model model = readScan(arguments.models.front(), subdivisions);
    counts.push_back(static_cast<double>(model.triangles()));
    times.push_back(addTriangles(model, arguments, table));
  }
  for (std::size_t m = 1; m < arguments.models.size(); ++m)
  {
    addTriangles(readScan(arguments.models[m], 0), arguments, table);
  }
  const Line line = lineThrough(counts, times);
  table.note("subdivided model: time = " + fixed(line.start, 3) + " s + " +
    fixed(1e6 * line.slope, 3) + " us * triangles; exponent over all " +
    fixed(exponentOf(counts, times), 2));
  table.print();
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 128, 256, 512 };
  const Arguments arguments = readArguments(argc, argv, defaults,
    "The time of vtkMeshSDF over samples (first mesh) and triangles (first mesh subdivided, then"
    " the others as they are).");
  printHeader("ScalingStudy", arguments);
  printSamples(readScan(arguments.models.front(), arguments.subdivisions), arguments);
  printTriangles(arguments);
  return 0;
}
