// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Random.h"

#include <cmath>

namespace robustness
{

Random::Random(std::uint64_t seed, Purpose purpose)
  : Engine(4 * seed + purpose)
{
}

std::size_t Random::index(std::size_t count)
{
  // 2^64 is so much more than any count here that the remainder's bias is nothing.
  return static_cast<std::size_t>(this->Engine() % count);
}

int Random::integer(int lowest, int highest)
{
  return lowest + static_cast<int>(this->index(static_cast<std::size_t>(highest - lowest) + 1));
}

double Random::real(double lowest, double highest)
{
  const double fraction = std::ldexp(static_cast<double>(this->Engine() >> 11), -53);
  return lowest + fraction * (highest - lowest);
}

double Random::logarithmic(double lowest, double highest)
{
  return std::exp(this->real(std::log(lowest), std::log(highest)));
}

bool Random::chance(double probability)
{
  return this->real(0.0, 1.0) < probability;
}

Vec3 Random::direction()
{
  for (;;)
  {
    const double x = this->real(-1.0, 1.0);
    const double y = this->real(-1.0, 1.0);
    const double z = this->real(-1.0, 1.0);
    const double squared = x * x + y * y + z * z;
    if (squared > 1e-6 && squared <= 1.0)
    {
      return Vec3(x, y, z) / std::sqrt(squared);
    }
  }
}

} // namespace robustness
