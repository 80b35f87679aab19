// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Random numbers that mean the same everywhere: the distributions of the standard library differ
 * between its makers, so these are our own.
 */

#ifndef ROBUSTNESS_RANDOM_H
#define ROBUSTNESS_RANDOM_H

#include "Types.h"

#include <cstdint>
#include <random>
#include <vector>

namespace robustness
{

using evolving::Vec3;

class Random
{
public:
  /// What a seed's numbers are for: each purpose has its own, whatever the others draw.
  enum Purpose : std::uint64_t
  {
    ForModel = 1,
    ForFilter = 2,
    ForParameters = 3
  };

  Random(std::uint64_t seed, Purpose purpose);

  /// From lowest to highest, both included.
  int integer(int lowest, int highest);
  double real(double lowest, double highest);
  /// Evenly over the orders of magnitude between two positive numbers.
  double logarithmic(double lowest, double highest);
  bool chance(double probability);
  /// Evenly over the sphere.
  Vec3 direction();
  /// A number below a count, which must not be 0.
  std::size_t index(std::size_t count);

  template <typename Value>
  const Value& pick(const std::vector<Value>& values)
  {
    return values[this->index(values.size())];
  }

private:
  std::mt19937_64 Engine;
};

} // namespace robustness

#endif
