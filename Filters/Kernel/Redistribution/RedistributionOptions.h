// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The parameters of the tangential velocities (section 3.3).
 */

#ifndef EVOLVING_REDISTRIBUTION_OPTIONS_H
#define EVOLVING_REDISTRIBUTION_OPTIONS_H

#include <tuple>

namespace evolving
{

/// What the volume-based redistribution makes the co-volumes proportional to: 1 / f(H), (3.21).
enum class CurvatureControl
{
  None = 0, ///< f = 1: uniform
  CubeRoot = 1,
  TwoThirds = 2,
  Exponential = 3,
};

/// What the angle-based redistribution does.
enum class AngleMethod
{
  WeightedEdges = 0, ///< (3.24)
  Shape = 1,         ///< the best place between the neighbours, see ElementShape
};

/// Section 6.2's cure for the accumulation of vertices by the angle-based velocity.
enum class AngleWeighting
{
  None = 0,
  InverseArea = 1,
  Distance = 2,
};

/// What boundary vertices may do.
enum class BoundaryMode
{
  Fixed = 0,
  SlideAlong = 1, ///< along the boundary curve only; corners stay
  Free = 2,
};

/// Rates of the tangential velocities, 1/time; 0 switches a term off (section 3.3).
struct RedistributionOptions
{
  double volume = 0.0;
  double angle = 0.0;
  double length = 0.0;
  AngleMethod angleMethod = AngleMethod::WeightedEdges;
  AngleWeighting angleWeighting = AngleWeighting::None;
  CurvatureControl curvatureControl = CurvatureControl::None;
  double curvatureControlAlpha = 1.0; ///< length, or fraction of L in relative units

  bool isActive() const { return this->volume > 0.0 || this->angle > 0.0 || this->length > 0.0; }
};

/// All of them: a new one does not compile before it is listed here.
inline auto membersOf(const RedistributionOptions& options)
{
  const auto& [volume, angle, length, angleMethod, angleWeighting, curvatureControl,
    curvatureControlAlpha] = options;
  return std::tie(
    volume, angle, length, angleMethod, angleWeighting, curvatureControl, curvatureControlAlpha);
}

bool operator==(const RedistributionOptions& a, const RedistributionOptions& b);

/// @throws InputError when a rate or alpha is not a finite number or negative.
void checkOptions(const RedistributionOptions& options);

} // namespace evolving

#endif
