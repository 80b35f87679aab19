// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * From a seed to an input.
 */

#ifndef ROBUSTNESS_GENERATOR_H
#define ROBUSTNESS_GENERATOR_H

#include "Model.h"

namespace robustness
{

/// A base shape with up to three defects, or a special model; then scale, place and precision.
Model makeModel(std::uint64_t seed);

} // namespace robustness

#endif
