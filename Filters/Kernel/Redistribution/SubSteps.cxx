// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/SubSteps.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

double angleLimit(AngleMethod method)
{
  return method == AngleMethod::Shape ? ExplicitLimits::Shape : ExplicitLimits::Angle;
}

} // namespace

SubSteps divideStep(
  double timeStep, const RedistributionOptions& redistribution, double advectionRate)
{
  const double wanted = timeStep *
    std::max({ redistribution.volume / ExplicitLimits::Volume,
      redistribution.angle / angleLimit(redistribution.angleMethod),
      redistribution.length / ExplicitLimits::Length, advectionRate / ExplicitLimits::Advection });
  SubSteps parts;
  // A rate that just reaches its limit, but for rounding, needs no second part.
  parts.count =
    static_cast<int>(std::clamp(std::ceil(wanted * (1.0 - 1e-12)), 1.0, double(MostSubSteps)));
  parts.timeStep = timeStep / parts.count;
  return parts;
}

RedistributionOptions limitRates(const RedistributionOptions& options, double subStep)
{
  RedistributionOptions limited = options;
  limited.volume = std::min(options.volume, ExplicitLimits::Volume / subStep);
  limited.angle = std::min(options.angle, angleLimit(options.angleMethod) / subStep);
  limited.length = std::min(options.length, ExplicitLimits::Length / subStep);
  return limited;
}

} // namespace evolving
