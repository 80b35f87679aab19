// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * One seed: its input, its filter, the answer and the verdict.
 */

#ifndef ROBUSTNESS_TRIAL_H
#define ROBUSTNESS_TRIAL_H

#include "FilterCase.h"
#include "Verdict.h"

#include <functional>
#include <string>

namespace robustness
{

/// Listens to a filter while it runs, and judges errors, warnings and outputs.
Verdict judgeAnswer(FilterCase& filterCase);

/**
 * @param kind the filter that the input goes through
 * @param describe called with what the trial is, before the filter runs
 */
Verdict runTrial(std::uint64_t seed, const FilterKind& kind,
  const std::function<void(const std::string&)>& describe);

} // namespace robustness

#endif
