// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FlowOptions.h"

#include "ParameterRange.h"

namespace evolving
{

bool operator==(const FlowOptions& a, const FlowOptions& b)
{
  return membersOf(a) == membersOf(b);
}

void checkOptions(const FlowOptions& options)
{
  const FlowOptions& o = options;
  checkRangeOrZero("TimeStep", o.timeStep, AboveZero, AnyNumber, "0 means an automatic one");
  checkRange("NumberOfSteps", o.numberOfSteps, 0.0, AnyNumber, "0 gives the start alone");
  checkRange("CurvatureSpeed", o.curvatureSpeed, 0.0, AnyNumber, "0 switches this term off");
  checkRange("CurvatureRange", o.curvatureRange, AboveZero, AnyNumber, "set 0.1 when in doubt");
  checkRange("AdvectionSpeed", o.advectionSpeed, 0.0, AnyNumber, "0 switches this term off");
  checkRange("AdvectionBalance", o.advectionBalance, 0.0, 1.0, "0 switches this term off");
  checkRange("EdgeSharpness", o.edgeSharpness, 0.0, AnyNumber, "0 means an automatic one");
  checkRange("NormalSpeed", o.normalSpeed, -AnyNumber, AnyNumber, "0 switches this term off");
  checkRange("SmoothingSteps", o.smoothingSteps, 0.0, AnyNumber, "0 switches smoothing off");
  checkRange("SmoothingSpeed", o.smoothingSpeed, 0.0, AnyNumber, "set 0.001 when in doubt");
  checkRange("SmoothingDecay", o.smoothingDecay, 0.0, AnyNumber, "0 keeps the speed as it is");
  checkRange("SurfaceGuard", o.surfaceGuard, 1.0, AnyNumber, "set 2 when in doubt");
  checkRange("ConvergenceTolerance", o.convergenceTolerance, 0.0, AnyNumber, "0 runs all steps");
  checkRange("LongestAdvection", o.longestAdvection, 0.0, AnyNumber, "0 sets no limit");
  checkRange("StallSteps", o.stallSteps, 0.0, AnyNumber, "0 sets no limit");
  checkRange("RemeshingInterval", o.remeshingInterval, 1.0, AnyNumber, "1 means every step");
  checkRange("SolverTolerance", o.solverTolerance, AboveZero, 0.1, "set 1e-10 when in doubt");
  checkOptions(o.redistribution);
}

FlowOptions inAbsoluteUnits(const FlowOptions& options, double lengthUnit)
{
  FlowOptions absolute = options;
  if (options.relativeUnits)
  {
    const double area = lengthUnit * lengthUnit;
    absolute.curvatureSpeed *= options.flow == Flow::SurfaceDiffusion ? area * area : area;
    absolute.curvatureRange *= area;
    absolute.smoothingSpeed *= area;
    absolute.redistribution.curvatureControlAlpha *= lengthUnit;
    absolute.relativeUnits = false;
    if (hasEdges(options.fieldMode))
    {
      absolute.advectionSpeed *= area;
      absolute.edgeSharpness *= area;
      absolute.normalSpeed *= lengthUnit;
    }
  }
  return absolute;
}

} // namespace evolving
