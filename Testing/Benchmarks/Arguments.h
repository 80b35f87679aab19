// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The command line that all benchmark programs share.
 */

#ifndef BENCHMARK_ARGUMENTS_H
#define BENCHMARK_ARGUMENTS_H

#include <map>
#include <string>
#include <vector>

namespace benchmark
{

struct Arguments
{
  static constexpr int Automatic = -1;

  std::vector<std::string> models; ///< mesh files; folders are opened; by default Data/bunny.ply
  std::vector<int> sizes;          ///< samples along each axis of the grids, or vertices
  int threads = 2;                 ///< of the measurements that use several
  int runs = 3;                    ///< of which the median is printed
  int subdivisions = Automatic;    ///< Loop's; automatic: towards 80,000 triangles
  std::map<std::string, bool> switches; ///< options without a value, of this program alone

  bool isOn(const std::string& name) const { return this->switches.at(name); }
};

/// The meshes that come with the project.
std::string dataFolder();

/**
 * `[--sizes N,N,...] [--threads N] [--runs N] [--subdivisions N] [MESH or FOLDER ...]` and the
 * switches. Leaves the program after --help, and after a mistake with one sentence.
 * @param defaults with the names of the switches
 * @param purpose what the program measures, for --help
 */
Arguments readArguments(
  int argc, char** argv, const Arguments& defaults, const std::string& purpose);

} // namespace benchmark

#endif
