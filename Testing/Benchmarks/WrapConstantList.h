// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The constants of shrink-wrapping that are varied, and where they matter.
 */

#ifndef BENCHMARK_WRAP_CONSTANT_LIST_H
#define BENCHMARK_WRAP_CONSTANT_LIST_H

#include "ShrinkWrap/ShrinkWrapOptions.h"
#include "ShrinkWrap/WrapTuning.h"

#include <functional>
#include <string>
#include <vector>

namespace benchmark
{

struct WrapConstant
{
  std::string name;
  double chosen = 0.0;
  std::vector<double> others; ///< values to try in its place
  std::function<void(evolving::WrapTuning&, double)> set;
};

/// What is wrapped how, and the constants that matter then.
struct WrapCase
{
  std::string name; ///< the switch of the program
  std::string title;
  evolving::ShrinkWrapOptions options;
  double offset = 0.0;   ///< in edge lengths
  bool asPoints = false; ///< without the faces, and with noise
  std::vector<WrapConstant> constants;
};

std::vector<WrapCase> wrapCases();

} // namespace benchmark

#endif
