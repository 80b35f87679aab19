// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/AutomaticTimeStep.h"

#include "Evolution/CurvatureLife.h"
#include "ParameterRange.h"
#include "VolumeFlows/RelaxationTime.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Of its first distance a surface is still away from its target at the end.
constexpr double DistanceLeft = 1e-3;
/// Of C: in hollows curvature holds against the advection, which brings a surface nearer at half of
/// the rate or so that it has elsewhere.
constexpr double HollowRate = 0.5;
/// As many as the filter makes by default: smoothing steps alone are as long as those of a run.
constexpr int UsualSteps = 150;

/// By curvature alone, with a speed of 1.
double timeOfCurvature(const SurfaceMesh& start, const FlowOptions& options)
{
  if (options.flow == Flow::SurfaceDiffusion)
  {
    return relaxationTimeOfDiffusion(start);
  }
  return options.volumePreserving ? relaxationTimeOfCurvatureFlow(start)
                                  : timeOfVisibleChange(start);
}

double totalTime(
  const SurfaceMesh& start, const ScalarImage* field, const FlowOptions& options, double size)
{
  const bool isDistance = field && options.fieldMode == FieldMode::DistanceField;
  if (isDistance && options.advectionSpeed > 0.0)
  {
    return -std::log(DistanceLeft) / (HollowRate * options.advectionSpeed);
  }
  if (options.curvatureSpeed > 0.0)
  {
    const double lives = field && !isDistance ? 2.0 : 1.0;
    return lives * timeOfCurvature(start, options) / options.curvatureSpeed;
  }
  return field && options.advectionSpeed > 0.0 ? size * size / options.advectionSpeed : 1.0;
}

} // namespace

double automaticTimeStep(
  const SurfaceMesh& start, const ScalarImage* field, const FlowOptions& options, double size)
{
  const int steps = options.numberOfSteps > 0 ? options.numberOfSteps : UsualSteps;
  const bool isBalloon = field && hasEdges(options.fieldMode) && options.normalSpeed != 0.0;
  const double timeStep = isBalloon
    ? field->grid().spacing.minCoeff() / std::abs(options.normalSpeed)
    : totalTime(start, field, options, size) / steps;
  // Speeds may be next to nothing, or as good as infinite.
  return std::clamp(timeStep, AboveZero, LongestTimeStep);
}

} // namespace evolving
