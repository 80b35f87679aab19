// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FlowOptions.h"

#include "Errors.h"

#include <limits>
#include <sstream>
#include <tuple>

namespace evolving
{

namespace
{

constexpr double Largest = std::numeric_limits<double>::max();
constexpr double SmallestPositive = std::numeric_limits<double>::min();

/// NaN and infinities are outside every range.
void checkRange(const char* name, double value, double smallest, double largest)
{
  if (!(value >= smallest && value <= largest))
  {
    std::ostringstream message;
    message << name << " is " << value << ", expected a number "
            << (smallest == SmallestPositive ? "above 0" : "of at least ");
    if (smallest != SmallestPositive)
    {
      message << smallest;
    }
    if (largest != Largest)
    {
      message << " and at most " << largest;
    }
    message << ".";
    throw InputError(message.str());
  }
}

auto members(const RedistributionOptions& o)
{
  return std::tie(o.volume, o.angle, o.length, o.angleMethod, o.angleWeighting, o.curvatureControl,
    o.curvatureControlAlpha);
}

auto members(const FlowOptions& o)
{
  return std::tie(o.timeStep, o.numberOfSteps, o.curvatureSpeed, o.curvatureRange, o.advectionSpeed,
    o.advectionBalance, o.relativeUnits, o.fieldMode, o.edgeSharpness, o.unsignedField,
    o.redistribution, o.smoothingSteps, o.smoothingSpeed, o.smoothingDecay, o.boundaryMode,
    o.surfaceGuard, o.convergenceTolerance, o.stallSteps, o.longestAdvection, o.remeshingInterval,
    o.solverTolerance);
}

} // namespace

bool operator==(const RedistributionOptions& a, const RedistributionOptions& b)
{
  return members(a) == members(b);
}

bool operator==(const FlowOptions& a, const FlowOptions& b)
{
  return members(a) == members(b);
}

void checkOptions(const RedistributionOptions& options)
{
  checkRange("The rate of the volume-based redistribution", options.volume, 0.0, Largest);
  checkRange("The rate of the angle-based redistribution", options.angle, 0.0, Largest);
  checkRange("The rate of the length-based redistribution", options.length, 0.0, Largest);
  checkRange("The curvature control's alpha", options.curvatureControlAlpha, 0.0, Largest);
}

void checkOptions(const FlowOptions& options)
{
  checkRange("The time step", options.timeStep, SmallestPositive, Largest);
  checkRange("The number of steps", options.numberOfSteps, 0.0, Largest);
  checkRange("The curvature speed", options.curvatureSpeed, 0.0, Largest);
  checkRange("The curvature range", options.curvatureRange, SmallestPositive, Largest);
  checkRange("The advection speed", options.advectionSpeed, 0.0, Largest);
  checkRange("The advection balance", options.advectionBalance, 0.0, 1.0);
  checkRange("The edge sharpness", options.edgeSharpness, 0.0, Largest);
  checkRange("The number of smoothing steps", options.smoothingSteps, 0.0, Largest);
  checkRange("The smoothing speed", options.smoothingSpeed, 0.0, Largest);
  checkRange("The smoothing decay", options.smoothingDecay, 0.0, Largest);
  checkRange("The surface guard", options.surfaceGuard, 1.0, Largest);
  checkRange("The convergence tolerance", options.convergenceTolerance, 0.0, Largest);
  checkRange("The longest advection", options.longestAdvection, 0.0, Largest);
  checkRange("The number of steps to a stall", options.stallSteps, 0.0, Largest);
  checkRange("The remeshing interval", options.remeshingInterval, 1.0, Largest);
  checkRange("The solver tolerance", options.solverTolerance, SmallestPositive, 0.1);
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
