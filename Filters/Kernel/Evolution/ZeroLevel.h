// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where a distance is zero, in samples.
 */

#ifndef EVOLVING_ZERO_LEVEL_H
#define EVOLVING_ZERO_LEVEL_H

#include "Evolution/ScalarImage.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// A sample next to the zero level of a distance, signed or not.
struct LevelSample
{
  std::array<int, 3> ijk = { 0, 0, 0 };
  Vec3 point = Vec3::Zero(); ///< in the world
  double distance = 0.0;     ///< of the level, without its sign
  double area = 0.0;         ///< of the level that the sample stands for
};

/**
 * The samples within two cells of the level. With the areas that they stand for, sums over them are
 * integrals over the level: the delta function of a distance, smeared out to a hat two cells wide
 * on either side, so that its sum over the samples along an axis across the level is 1 wherever the
 * level lies between them. A plate thinner than four cells has a little less.
 * Engquist, Tornberg, Tsai, "Discretization of Dirac delta functions in level set methods",
 * J. Comput. Phys. 207, 2005.
 */
std::vector<LevelSample> zeroLevel(const ScalarImage& distance);

/// The area of the level; 0 when no sample is near it.
double zeroLevelArea(const ScalarImage& distance);

} // namespace evolving

#endif
