// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where to split a box of triangles: the minimum of the surface area heuristic, from eight
 * samples and the parabolas between them (section 5.1 and figure 5.3 of the thesis, after Hunt,
 * Mark, Stoll, Fast kd-tree Construction with an Adaptive Error-Bounded Heuristic, 2006).
 */

#ifndef EVOLVING_SURFACE_AREA_SPLIT_H
#define EVOLVING_SURFACE_AREA_SPLIT_H

#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// The cost C_L SA_L / SA + C_R SA_R / SA of a split, relative to that of one triangle.
struct SplitSample
{
  float position = 0.0F; ///< in [0, 1] along the box's split axis
  float leftCount = 0.0F;
  float rightCount = 0.0F;
  float cost = 0.0F;
};

/// The cost between two neighbouring samples, counts taken as linear: a t^2 + b t + c.
struct SplitParabola
{
  float from = 0.0F;
  float to = 0.0F;
  std::array<float, 3> coefficients{}; ///< a, b, c, with t the position

  float at(float t) const;
  /// Where in [from, to] the parabola is lowest.
  float lowest() const;
};

/// What a search looked at and what it found.
struct SplitSearch
{
  static constexpr int Samples = 10; ///< the ends of the box and two times four

  std::array<SplitSample, Samples> samples; ///< in ascending order of position
  std::array<SplitParabola, Samples - 1> parabolas;
  float position = 0.5F; ///< in (0, 1) along the axis
  float cost = 0.0F;     ///< of the parabola there
};

/// From where to where a triangle reaches along the split axis, the box being [0, 1].
struct SplitInterval
{
  float low = 0.0F;
  float high = 0.0F;
};

/**
 * The best position to split a box along an axis. A triangle counts on the left when it begins
 * before the position, on the right when it ends behind it, on both sides when both.
 * Four equidistant positions are counted together in one SIMD register, then four more where
 * the counts change fastest.
 * @param sides the box's sides; only their ratios matter
 */
SplitSearch searchSplit(const Vec3& sides, int axis, const std::vector<SplitInterval>& intervals);

} // namespace evolving

#endif
