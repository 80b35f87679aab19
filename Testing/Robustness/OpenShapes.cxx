// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShapeParts.h"

#include <cmath>

namespace robustness
{

Model makeSheet(Random& random)
{
  const double wave = random.chance(0.5) ? 0.0 : random.real(0.0, 0.3);
  return lattice(random.integer(1, 12), random.integer(1, 12), false, false,
    [wave](double u, double v) -> Vec3 {
      return { 2.0 * u - 1.0, 2.0 * v - 1.0, wave * std::sin(6.0 * u) * std::cos(5.0 * v) };
    });
}

Model makeTube(Random& random)
{
  const double radius = random.logarithmic(0.05, 0.8);
  return lattice(random.integer(3, 16), random.integer(1, 8), true, false,
    [radius](double u, double v) -> Vec3 {
      return { radius * std::cos(2.0 * Pi * u), radius * std::sin(2.0 * Pi * u), 2.0 * v - 1.0 };
    });
}

/// Half turns of a band: joined by coordinates, one-sided for an odd number.
Model makeBand(Random& random)
{
  const int halfTurns = random.integer(1, 3);
  const int n = random.integer(12, 40);
  Model model = lattice(n, 2, false, false,
    [halfTurns](double u, double v) -> Vec3
    {
      const double twist = halfTurns * Pi * u;
      const double radius = 1.0 + 0.4 * (v - 0.5) * std::cos(twist);
      return { radius * std::cos(2.0 * Pi * u), radius * std::sin(2.0 * Pi * u),
        0.4 * (v - 0.5) * std::sin(twist) };
    });
  for (int j = 0; j <= 2; ++j)
  {
    const int other = halfTurns % 2 == 0 ? j : 2 - j;
    model.points[std::size_t(j * (n + 1) + n)] = model.points[std::size_t(other * (n + 1))];
  }
  return model;
}

/// Crosses itself along a circle, and has no inside.
Model makeKleinBottle(Random& random)
{
  const int n = random.integer(10, 24);
  return lattice(n, 12, true, true,
    [](double u, double v) -> Vec3
    {
      const double a = 2.0 * Pi * u, b = 2.0 * Pi * v;
      const double r =
        2.0 + std::cos(0.5 * a) * std::sin(b) - std::sin(0.5 * a) * std::sin(2.0 * b);
      return Vec3(r * std::cos(a), r * std::sin(a),
               std::sin(0.5 * a) * std::sin(b) + std::cos(0.5 * a) * std::sin(2.0 * b)) /
        3.0;
    });
}

} // namespace robustness
