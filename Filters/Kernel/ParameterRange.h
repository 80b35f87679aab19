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
 * NaN and infinities are outside every range: the filters' setters clamp numbers, but cannot clamp
 * what is none, so that every option that is a number passes here.
 * @param name of the parameter as users know it, "TimeStep"; it begins the sentence
 * @param advice that ends the sentence, "set 0.03 when in doubt"
 * @throws InputError unless value is in [smallest, largest]
 */
void checkRange(
  const char* name, double value, double smallest, double largest, const char* advice);

/// As checkRange(), of a parameter that may also be 0, which means something else.
void checkRangeOrZero(
  const char* name, double value, double smallest, double largest, const char* advice);

} // namespace evolving

#endif
