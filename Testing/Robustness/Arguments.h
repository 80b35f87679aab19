// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The command line of RobustnessRunner.
 */

#ifndef ROBUSTNESS_ARGUMENTS_H
#define ROBUSTNESS_ARGUMENTS_H

#include <cstdint>
#include <optional>
#include <string>

namespace robustness
{

struct Arguments
{
  std::uint64_t seed = 1;
  std::uint64_t count = 300; ///< 0: until the time is up
  int seconds = 0;           ///< 0: until all inputs are done
  int jobs = 0;              ///< 0: as many as there are cores
  int timeLimit = 60;        ///< processor seconds of an input
  std::string only;          ///< a filter's name; empty: the seed chooses
  std::optional<std::uint64_t> repeat;
  std::string save;
  std::string show; ///< a good outcome whose inputs are printed too
};

/// Leaves the program after --help, and after a mistake with one sentence.
Arguments readArguments(int argc, char** argv);

} // namespace robustness

#endif
