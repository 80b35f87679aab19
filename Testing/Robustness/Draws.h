// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Parameters of a filter: nearly always sensible, sometimes what nobody would type in.
 */

#ifndef ROBUSTNESS_DRAWS_H
#define ROBUSTNESS_DRAWS_H

#include "Random.h"

#include <set>
#include <string>

class vtkAlgorithm;

namespace robustness
{

class Draws
{
public:
  /// One trial in eight is odd: only there numbers may be no good.
  explicit Draws(Random& random);

  Random& random() { return this->Source; }
  /// The sensible number, or in odd trials now and then NaN, infinity, a limit.
  double number(const std::string& name, double sensible);
  /// 0, or with a probability a number between the others, evenly over the orders of magnitude.
  double rate(const std::string& name, double probability, double lowest, double highest);
  bool isOdd() const { return this->Odd; }
  bool isNaN(const std::string& name) const { return this->NaNs.count(name) > 0; }
  /// Has a number been drawn that is not the sensible one?
  bool areSensible() const { return this->Sensible; }

private:
  Random& Source;
  bool Odd = false;
  bool Sensible = true;
  std::set<std::string> NaNs;
};

/// What PrintSelf() says of the filter's own parameters that are not the defaults.
std::string parametersOf(vtkAlgorithm* filter);

} // namespace robustness

#endif
