// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ShrinkWrapOptions.h"

#include "Errors.h"

#include <cmath>
#include <sstream>
#include <tuple>

namespace evolving
{

namespace
{

/// Of a cube an edge is then three cells of the default grid long: the grid shows what elements of
/// that size can carry.
constexpr double DefaultVertexCount = 9000.0;

/// The flow leaves exp(-time) of a distance. The start is half an edge length away: after this time
/// a twentieth of that is left. Four steps are the fewest whose explicit part is well within
/// ExplicitLimits::Advection.
constexpr double IsosurfaceTime = 3.0;
constexpr int IsosurfaceSteps = 4;
/// From a sphere vertices move half an edge of an element in a step at most, and elements are up to
/// six times as large there (FlowTuning): 50 steps lead 150 edge lengths far, beyond any target of
/// that many vertices; those left over end by FlowOptions::convergenceTolerance.
constexpr double IcosphereTime = 25.0;
constexpr int IcosphereSteps = 50;

} // namespace

bool operator==(const ShrinkWrapOptions& a, const ShrinkWrapOptions& b)
{
  const auto values = [](const ShrinkWrapOptions& o)
  {
    return std::tie(o.start, o.sampleDimensions, o.targetEdgeLength, o.gapSize, o.adaptToCurvature,
      o.preserveFeatures, o.featureAngle, o.numberOfSteps, o.offsetDistance);
  };
  return values(a) == values(b);
}

void checkOptions(const ShrinkWrapOptions& options)
{
  std::ostringstream message;
  for (const double length : { options.targetEdgeLength, options.gapSize, options.offsetDistance })
  {
    if (!std::isfinite(length) || length < 0.0)
    {
      message << "TargetEdgeLength, GapSize or OffsetDistance is " << length
              << ", expected a finite length of at least 0; set 0 for an automatic one.";
      throw InputError(message.str());
    }
  }
  if (!(options.featureAngle >= 0.0 && options.featureAngle <= 180.0))
  {
    message << "FeatureAngle is " << options.featureAngle
            << ", expected 0 to 180 degrees; set 45 when in doubt.";
    throw InputError(message.str());
  }
  if (options.numberOfSteps < 0)
  {
    message << "NumberOfSteps is " << options.numberOfSteps
            << ", expected 0 or more; set 0 for an automatic number.";
    throw InputError(message.str());
  }
}

int stepsOf(const ShrinkWrapOptions& options)
{
  const bool fromSphere = options.start == WrapStart::Icosphere;
  const int automatic = fromSphere ? IcosphereSteps : IsosurfaceSteps;
  return options.numberOfSteps > 0 ? options.numberOfSteps : automatic;
}

double timeStepOf(const ShrinkWrapOptions& options)
{
  const bool fromSphere = options.start == WrapStart::Icosphere;
  return (fromSphere ? IcosphereTime : IsosurfaceTime) / stepsOf(options);
}

double defaultEdgeLength(double area)
{
  return std::sqrt(2.0 * area / (DefaultVertexCount * std::sqrt(3.0)));
}

} // namespace evolving
