// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FlowSetup.h"

#include "Errors.h"
#include "Evolution/AutomaticTimeStep.h"
#include "Mesh/TopologySummary.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

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

/// Where nothing else moves the surface, and it encloses what it is to keep.
void checkFlow(const SurfaceMesh& start, const ScalarImage* field, const FlowOptions& options)
{
  if (!options.holdsVolume())
  {
    return;
  }
  const bool isDiffusion = options.flow == Flow::SurfaceDiffusion;
  const std::string name = isDiffusion ? "Surface diffusion" : "A volume-preserving flow";
  if (field)
  {
    throw InputError(name +
      " got a field, expected none: it would move the surface against its own volume; disconnect "
      "the field, or " +
      (isDiffusion ? "set Flow to MeanCurvature." : "switch VolumePreserving off."));
  }
  if (!summarizeTopology(start).isClosed() &&
    (isDiffusion || options.boundaryMode != BoundaryMode::Fixed))
  {
    throw InputError(name + " got a start surface with a boundary" +
      (isDiffusion ? "" : " that may move") + ", expected a closed one" +
      (isDiffusion ? "" : " or a boundary that rests") + "; close it first, for example with " +
      "vtkShrinkWrap" + (isDiffusion ? "." : ", or set BoundaryMode to Fixed."));
  }
}

/// The rate of what moves the surface explicitly: C sqrt(1 + D^2) towards a target, and a cell of
/// an image by the normal speed. The pull of edges is none, see StepInput.
double advectionRate(const FlowOptions& options, const ScalarImage* field)
{
  if (!field)
  {
    return 0.0;
  }
  return hasEdges(options.fieldMode)
    ? std::abs(options.normalSpeed) / field->grid().spacing.minCoeff()
    : options.advectionSpeed * std::hypot(1.0, options.advectionBalance);
}

/// 1 / time: of the flow's own time.
double rateOf(const FlowOptions& options, const ScalarImage* field, double size)
{
  const double perArea = 1.0 / (size * size);
  if (options.flow == Flow::SurfaceDiffusion)
  {
    return options.curvatureSpeed * perArea * perArea;
  }
  if (!field || options.advectionSpeed == 0.0)
  {
    return options.curvatureSpeed * perArea;
  }
  const bool isDistance = options.fieldMode == FieldMode::DistanceField;
  return isDistance ? options.advectionSpeed : options.advectionSpeed * perArea;
}

} // namespace

FlowSetup setUpFlow(const SurfaceMesh& start, const ScalarImage* field, const FlowOptions& options)
{
  checkOptions(options);
  checkStart(start);
  checkFlow(start, field, options);
  FlowSetup setup;
  setup.size = sizeOf(start, field, options.fieldMode);
  setup.lengthUnit = options.relativeUnits ? setup.size : 1.0;
  setup.options = inAbsoluteUnits(options, setup.lengthUnit);
  if (options.timeStep == 0.0)
  {
    setup.options.timeStep = automaticTimeStep(start, field, setup.options, setup.size);
  }
  setup.restingMove = options.convergenceTolerance * setup.size *
    rateOf(setup.options, field, setup.size) * setup.options.timeStep;
  const double rate = advectionRate(setup.options, field);
  setup.parts = divideStep(setup.options.timeStep, options.redistribution, rate);
  setup.options.redistribution = limitRates(setup.options.redistribution, setup.parts.timeStep);
  double& speed =
    field && hasEdges(options.fieldMode) ? setup.options.normalSpeed : setup.options.advectionSpeed;
  speed /= std::max(1.0, rate * setup.parts.timeStep / ExplicitLimits::Advection);
  return setup;
}

} // namespace evolving
