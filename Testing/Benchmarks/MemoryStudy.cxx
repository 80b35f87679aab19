// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The peak memory of vtkMeshSDF beyond its input, output included, each measurement in a process
 * of its own.
 */

#include "Arguments.h"
#include "Models.h"
#include "PeakMemory.h"
#include "Report.h"
#include "SampledDistance.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using namespace benchmark;

namespace
{

/// FastSweeping and BruteForce are measured up to this size.
constexpr int LargestOfOtherMethods = 256;

struct Method
{
  std::string name;
  int method;
  int sign;
};

/// Peak bytes of one run, or 0 where /proc does not tell. For a process of its own.
double peakOf(const std::string& path, int subdivisions, const Sampling& sampling)
{
  const Model scan = readScan(path, subdivisions);
  PeakMemory memory;
  if (!memory.start())
  {
    return 0.0;
  }
  const auto image = sampleDistance(scan.surface, sampling);
  return memory.bytes();
}

/// peakOf() in a child process, which hands its figure back through a pipe.
double peakApart(const std::string& path, int subdivisions, const Sampling& sampling)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    return 0.0;
  }
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0)
  {
    const double peak = peakOf(path, subdivisions, sampling);
    const bool sent = write(ends[1], &peak, sizeof(peak)) == sizeof(peak);
    _exit(sent ? 0 : 1);
  }
  close(ends[1]);
  double peak = 0.0;
  const bool received = read(ends[0], &peak, sizeof(peak)) == sizeof(peak);
  close(ends[0]);
  waitpid(child, nullptr, 0);
  return received ? peak : 0.0;
}

void addMethod(
  const std::string& path, const Method& method, const Arguments& arguments, Table& table)
{
  double lastSamples = 0.0;
  double lastPeak = 0.0;
  for (const int size : arguments.sizes)
  {
    if (method.method != vtkMeshSDF::CLOSEST_POINT && size > LargestOfOtherMethods)
    {
      continue;
    }
    const Sampling sampling{ size, method.method, method.sign, arguments.threads };
    const double peak = peakApart(path, arguments.subdivisions, sampling);
    const double samples = std::pow(static_cast<double>(size), 3.0);
    if (peak <= 0.0)
    {
      table.add({ method.name, cube(size), "not available (needs Linux's /proc)" });
      continue;
    }
    std::vector<std::string> row{ method.name, cube(size), fixed(peak / 1048576.0, 1),
      fixed(peak / samples, 1) };
    if (lastSamples > 0.0)
    {
      row.push_back(fixed((peak - lastPeak) / (samples - lastSamples), 1));
    }
    table.add(row);
    lastSamples = samples;
    lastPeak = peak;
  }
}

} // namespace

int main(int argc, char** argv)
{
  Arguments defaults;
  defaults.sizes = { 128, 256, 512 };
  defaults.runs = 1;
  const Arguments arguments = readArguments(
    argc, argv, defaults, "The peak memory of vtkMeshSDF beyond its input, default outputs.");
  printHeader("MemoryStudy", arguments);
  for (const std::string& path : arguments.models)
  {
    Table table("Peak memory beyond the input, output included: " +
        readScan(path, arguments.subdivisions).name,
      { "method", "grid", "MiB", "bytes a sample", "bytes a further sample" });
    addMethod(
      path, { "ClosestPoint", vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::AUTOMATIC }, arguments, table);
    addMethod(path,
      { "FastSweeping, FloodFill", vtkMeshSDF::FAST_SWEEPING, vtkMeshSDF::FLOOD_FILL }, arguments,
      table);
    addMethod(
      path, { "BruteForce", vtkMeshSDF::BRUTE_FORCE, vtkMeshSDF::AUTOMATIC }, arguments, table);
    table.note("'bytes a further sample' is the growth from the grid above: without the tree.");
    table.print();
  }
  return 0;
}
