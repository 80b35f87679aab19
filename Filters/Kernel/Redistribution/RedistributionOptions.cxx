// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/RedistributionOptions.h"

#include "ParameterRange.h"

namespace evolving
{

bool operator==(const RedistributionOptions& a, const RedistributionOptions& b)
{
  return membersOf(a) == membersOf(b);
}

void checkOptions(const RedistributionOptions& options)
{
  constexpr char Off[] = "0 switches this term off";
  checkRange("VolumeRedistribution", options.volume, 0.0, AnyNumber, Off);
  checkRange("AngleRedistribution", options.angle, 0.0, AnyNumber, Off);
  checkRange("LengthRedistribution", options.length, 0.0, AnyNumber, Off);
  checkRange("CurvatureControlAlpha", options.curvatureControlAlpha, 0.0, AnyNumber,
    "set 0.1 when in doubt");
}

} // namespace evolving
