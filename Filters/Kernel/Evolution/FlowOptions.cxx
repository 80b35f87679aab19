// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FlowOptions.h"

#include "ParameterRange.h"

#include <tuple>

namespace evolving
{

namespace
{

auto members(const FlowOptions& o)
{
  return std::tie(o.timeStep, o.numberOfSteps, o.curvatureSpeed, o.curvatureRange, o.advectionSpeed,
    o.advectionBalance, o.relativeUnits, o.fieldMode, o.edgeSharpness, o.unsignedField,
    o.redistribution, o.smoothingSteps, o.smoothingSpeed, o.smoothingDecay, o.boundaryMode,
    o.surfaceGuard, o.convergenceTolerance, o.stallSteps, o.longestAdvection, o.remeshingInterval,
    o.solverTolerance);
}

} // namespace

bool operator==(const FlowOptions& a, const FlowOptions& b)
{
  return members(a) == members(b);
}

void checkOptions(const FlowOptions& options)
{
  checkRange("The time step", options.timeStep, AboveZero, AnyNumber);
  checkRange("The number of steps", options.numberOfSteps, 0.0, AnyNumber);
  checkRange("The curvature speed", options.curvatureSpeed, 0.0, AnyNumber);
  checkRange("The curvature range", options.curvatureRange, AboveZero, AnyNumber);
  checkRange("The advection speed", options.advectionSpeed, 0.0, AnyNumber);
  checkRange("The advection balance", options.advectionBalance, 0.0, 1.0);
  checkRange("The edge sharpness", options.edgeSharpness, 0.0, AnyNumber);
  checkRange("The number of smoothing steps", options.smoothingSteps, 0.0, AnyNumber);
  checkRange("The smoothing speed", options.smoothingSpeed, 0.0, AnyNumber);
  checkRange("The smoothing decay", options.smoothingDecay, 0.0, AnyNumber);
  checkRange("The surface guard", options.surfaceGuard, 1.0, AnyNumber);
  checkRange("The convergence tolerance", options.convergenceTolerance, 0.0, AnyNumber);
  checkRange("The longest advection", options.longestAdvection, 0.0, AnyNumber);
  checkRange("The number of steps to a stall", options.stallSteps, 0.0, AnyNumber);
  checkRange("The remeshing interval", options.remeshingInterval, 1.0, AnyNumber);
  checkRange("The solver tolerance", options.solverTolerance, AboveZero, 0.1);
  checkOptions(options.redistribution);
}

FlowOptions inAbsoluteUnits(const FlowOptions& options, double lengthUnit)
{
  FlowOptions absolute = options;
  if (options.relativeUnits)
  {
    const double area = lengthUnit * lengthUnit;
    absolute.curvatureSpeed *= area;
    absolute.curvatureRange *= area;
    absolute.smoothingSpeed *= area;
    absolute.redistribution.curvatureControlAlpha *= lengthUnit;
    absolute.relativeUnits = false;
    if (options.fieldMode == FieldMode::EdgeDetector)
    {
      absolute.advectionSpeed *= area;
      absolute.edgeSharpness *= area;
    }
  }
  return absolute;
}

} // namespace evolving
