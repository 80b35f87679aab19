// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/RedistributionOptions.h"

#include "ParameterRange.h"

#include <tuple>

namespace evolving
{

namespace
{

auto members(const RedistributionOptions& o)
{
  return std::tie(o.volume, o.angle, o.length, o.angleMethod, o.angleWeighting, o.curvatureControl,
    o.curvatureControlAlpha);
}

} // namespace

bool operator==(const RedistributionOptions& a, const RedistributionOptions& b)
{
  return members(a) == members(b);
}

void checkOptions(const RedistributionOptions& options)
{
  checkRange("The rate of the volume-based redistribution", options.volume, 0.0, AnyNumber);
  checkRange("The rate of the angle-based redistribution", options.angle, 0.0, AnyNumber);
  checkRange("The rate of the length-based redistribution", options.length, 0.0, AnyNumber);
  checkRange("The curvature control's alpha", options.curvatureControlAlpha, 0.0, AnyNumber);
}

} // namespace evolving
