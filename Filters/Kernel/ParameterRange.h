// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * One sentence for a parameter that is out of its range.
 */

#ifndef EVOLVING_PARAMETER_RANGE_H
#define EVOLVING_PARAMETER_RANGE_H

#include <limits>

namespace evolving
{

/// No upper limit but that of numbers.
constexpr double AnyNumber = std::numeric_limits<double>::max();
/// As a lower limit: 0 itself is too small.
constexpr double AboveZero = std::numeric_limits<double>::min();

/**
 * NaN and infinities are outside every range.
 * @param name that begins the sentence, "The time step"
 * @throws InputError unless value is in [smallest, largest]
 */
void checkRange(const char* name, double value, double smallest, double largest);

} // namespace evolving

#endif
