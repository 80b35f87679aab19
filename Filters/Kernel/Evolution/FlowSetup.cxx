// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FlowSetup.h"

#include "Errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace evolving
{

namespace
{

double sizeOf(const SurfaceMesh& start, const ScalarImage* field, FieldMode mode)
{
  Box box;
  if (field && mode == FieldMode::DistanceField)
  {
    box = field->insideBox();
  }
  if (box.isEmpty() || !(box.diagonal().norm() > 0.0))
  {
    box = boundingBox(start);
  }
  return 0.5 * box.diagonal().norm();
}

void checkStart(const SurfaceMesh& start)
{
  validate(start);
  if (start.faceCount() == 0 || !(surfaceArea(start) > 0.0))
  {
    std::ostringstream message;
    message << "The start surface has " << start.faceCount() << " faces with a total area of "
            << surfaceArea(start) << ", expected faces of positive area.";
    throw InputError(message.str());
  }
}

/// C sqrt(1 + D^2): the rate of the explicit pull towards a target.
double advectionRate(const FlowOptions& options, const ScalarImage* field)
{
  const bool isPulled = field && options.fieldMode == FieldMode::DistanceField;
  return isPulled ? options.advectionSpeed * std::hypot(1.0, options.advectionBalance) : 0.0;
}

} // namespace

FlowSetup setUpFlow(const SurfaceMesh& start, const ScalarImage* field, const FlowOptions& options)
{
  checkOptions(options);
  checkStart(start);
  FlowSetup setup;
  setup.size = sizeOf(start, field, options.fieldMode);
  setup.lengthUnit = options.relativeUnits ? setup.size : 1.0;
  const double rate = advectionRate(options, field);
  setup.parts = divideStep(options.timeStep, options.redistribution, rate);
  setup.options = inAbsoluteUnits(options, setup.lengthUnit);
  setup.options.redistribution = limitRates(setup.options.redistribution, setup.parts.timeStep);
  setup.options.advectionSpeed /=
    std::max(1.0, rate * setup.parts.timeStep / ExplicitLimits::Advection);
  return setup;
}

} // namespace evolving
