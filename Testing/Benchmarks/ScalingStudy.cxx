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

/// Growth from each grid to the next, of one kind of time.
class Growth
{
public:
  /// "b" of a + b * samples through the last two grids in ns, and its ratio to the one before.
  std::vector<std::string> add(int size, double seconds)
  {
    this->Counts.push_back(samples(size));
    this->Times.push_back(seconds);
    const std::size_t n = this->Times.size();
    if (n < 2)
    {
      return { "", "" };
    }
    const double last = this->Slope;
    this->Slope = (seconds - this->Times[n - 2]) / (this->Counts[n - 1] - this->Counts[n - 2]);
    return { fixed(1e9 * this->Slope, 1), n > 2 ? fixed(this->Slope / last, 2) : "" };
  }

  std::string fit() const
  {
    const Line line = lineThrough(this->Counts, this->Times);
    return "a = " + fixed(line.start, 3) + " s, b = " + fixed(1e9 * line.slope, 1) + " ns";
  }

private:
  std::vector<double> Counts;
  std::vector<double> Times;
  double Slope = 0.0;
};

void printSamples(const Model& model, const Arguments& arguments)
{
  Table table("vtkMeshSDF over samples, default parameters, " + std::to_string(arguments.threads) +
      " threads: " + model.name,
    { "grid", "seconds", "ns a sample", "b, ns", "to the b before", "processor time", "b, ns",
      "to the b before" });
  Growth wall;
  Growth cpu;
  for (const int size : arguments.sizes)
  {
    const Sampling sampling{ size, vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::AUTOMATIC,
      arguments.threads };
    const Seconds time = medianOf(arguments.runs, [&] { sampleDistance(model.surface, sampling); });
    std::vector<std::string> row{ cube(size), fixed(time.wall, 3),
      fixed(1e9 * time.wall / samples(size), 1) };
    const auto wallGrowth = wall.add(size, time.wall);
    row.insert(row.end(), wallGrowth.begin(), wallGrowth.end());
    row.push_back(fixed(time.cpu, 3));
    const auto cpuGrowth = cpu.add(size, time.cpu);
    row.insert(row.end(), cpuGrowth.begin(), cpuGrowth.end());
    table.add(row);
  }
  if (arguments.sizes.size() > 1)
  {
    table.note("time = a + b * samples, over all grids: " + wall.fit());
    table.note("the same of processor time: " + cpu.fit());
  }
  table.note("'b' is the slope from the grid above to this one.");
  table.print();
}

/// @return the time of vtkMeshSDF
Seconds addTriangles(const Model& model, const Arguments& arguments, Table& table)
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
  return time;
}

/// The first model at several subdivisions, the others as they are.
void printTriangles(const Arguments& arguments)
{
  Table table("vtkMeshSDF over triangles at " + cube(TriangleGrid) + ", default parameters, " +
      std::to_string(arguments.threads) + " threads",
    { "mesh", "triangles", "sign", "prepare", "seconds", "processor time", "us a triangle" });
  std::vector<double> counts;
  std::vector<double> wall;
  std::vector<double> cpu;
  for (int subdivisions = 0; subdivisions <= FinestSubdivision; ++subdivisions)
  {
    const Model model = readScan(arguments.models.front(), subdivisions);
    counts.push_back(static_cast<double>(model.triangles()));
    const Seconds time = addTriangles(model, arguments, table);
    wall.push_back(time.wall);
    cpu.push_back(time.cpu);
  }
  for (std::size_t m = 1; m < arguments.models.size(); ++m)
  {
    addTriangles(readScan(arguments.models[m], 0), arguments, table);
  }
  table.note("subdivided model: time grows like triangles^" + fixed(exponentOf(counts, wall), 2) +
    ", processor time like triangles^" + fixed(exponentOf(counts, cpu), 2));
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
