// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The parameters of an evolution.
 */

#ifndef EVOLVING_FLOW_OPTIONS_H
#define EVOLVING_FLOW_OPTIONS_H

#include "Redistribution/RedistributionOptions.h"

#include <tuple>

namespace evolving
{

/// What the scalar image is.
enum class FieldMode
{
  DistanceField = 0, ///< signed distance, the flow of section 3.2, (3.7) to (3.9)
  Image = 1,         ///< intensities I, whose edge detector e is computed
  EdgeImage = 2,     ///< e itself
};

/// Is the surface drawn to the edges of an image?
inline bool hasEdges(FieldMode mode)
{
  return mode != FieldMode::DistanceField;
}

/// What moves a surface where no field does.
enum class Flow
{
  MeanCurvature = 0,    ///< d_t F = C1 Laplace F
  SurfaceDiffusion = 1, ///< d_t F = C1 Laplace_S H N, see SurfaceDiffusion; C1 in length^4/time
};

/// Times beyond it, multiplied by numbers of steps and speeds, would soon be none.
constexpr double LongestTimeStep = 1e12;

struct FlowOptions
{
  double timeStep = 0.01; ///< 0 = automatic, see automaticTimeStep()
  int numberOfSteps = 100;
  Flow flow = Flow::MeanCurvature;
  bool volumePreserving = false; ///< adds what keeps each component's volume, see HeldVolumes
  double curvatureSpeed = 1.0;   ///< C1 of (3.7), b of an edge detector; epsilon without a field
  double curvatureRange = 1.0;   ///< C2 of (3.7)
  double advectionSpeed = 1.0;   ///< C of (3.8); a of an edge detector
  double advectionBalance = 0.0; ///< D of (3.8), in [0, 1]
  bool relativeUnits = true;     ///< see inAbsoluteUnits()
  FieldMode fieldMode = FieldMode::DistanceField;
  double edgeSharpness = 0.0; ///< K; 0 = automatic, see automaticEdgeDetector()
  double normalSpeed = 0.0;   ///< of an edge detector where e is 1, outwards; below 0 inwards
  bool unsignedField = false; ///< D = 0 within two cells of the target
  RedistributionOptions redistribution;
  int smoothingSteps = 0;
  double smoothingSpeed = 0.0; ///< S0
  double smoothingDecay = 0.0; ///< lambda, per smoothing step
  BoundaryMode boundaryMode = BoundaryMode::Fixed;
  double surfaceGuard = 2.0;         ///< of the box of start and field; leaving it ends the flow
  double convergenceTolerance = 0.0; ///< see FlowSetup::restingMove; 0 = run all steps
  int stallSteps = 0; ///< without getting nearer to the target, see StallTest; 0 = any number
  double longestAdvection = 0.0; ///< of a vertex in a step, in its mean edge lengths; 0 = any
  int remeshingInterval = 1;     ///< steps from remeshing to remeshing, with a remesher
  double solverTolerance = 1e-10;
  bool tracesStart = false; ///< keeps FlowState::startPoints, with a remesher

  int totalSteps() const { return this->numberOfSteps + this->smoothingSteps; }
  /// Is the step after that iteration one of the smoothing steps?
  bool isSmoothing(int iteration) const
  {
    return this->smoothingSteps > 0 && iteration >= this->numberOfSteps;
  }
  /// Surface diffusion does so anyway, but for what a time step is too long for.
  bool holdsVolume() const
  {
    return this->volumePreserving || this->flow == Flow::SurfaceDiffusion;
  }
  bool isRemeshingDue(int iteration) const { return iteration % this->remeshingInterval == 0; }
};

/// All of them: a new one does not compile before it is listed here.
inline auto membersOf(const FlowOptions& options)
{
  const auto& [timeStep, numberOfSteps, flow, volumePreserving, curvatureSpeed, curvatureRange,
    advectionSpeed, advectionBalance, relativeUnits, fieldMode, edgeSharpness, normalSpeed,
    unsignedField, redistribution, smoothingSteps, smoothingSpeed, smoothingDecay, boundaryMode,
    surfaceGuard, convergenceTolerance, stallSteps, longestAdvection, remeshingInterval,
    solverTolerance, tracesStart] = options;
  return std::tie(timeStep, numberOfSteps, flow, volumePreserving, curvatureSpeed, curvatureRange,
    advectionSpeed, advectionBalance, relativeUnits, fieldMode, edgeSharpness, normalSpeed,
    unsignedField, redistribution, smoothingSteps, smoothingSpeed, smoothingDecay, boundaryMode,
    surfaceGuard, convergenceTolerance, stallSteps, longestAdvection, remeshingInterval,
    solverTolerance, tracesStart);
}

bool operator==(const FlowOptions& a, const FlowOptions& b);

/**
 * @throws InputError when a parameter is not a finite number or out of its range:
 * curvatureRange positive, the time step, counts, speeds and rates not negative, advectionBalance
 * in [0, 1], longestAdvection not negative, solverTolerance in (0, 0.1], surfaceGuard and
 * remeshingInterval at least 1.
 */
void checkOptions(const FlowOptions& options);

/**
 * The options with all lengths in the input's unit: C1, S0 and C2 times L^2 and alpha times L;
 * for surface diffusion C1 times L^4.
 * For an edge detector a and K, an area per time and an area per squared intensity, are
 * multiplied by L^2 too, and the normal speed by L. Unchanged when they are absolute already.
 * @param lengthUnit L
 */
FlowOptions inAbsoluteUnits(const FlowOptions& options, double lengthUnit);

} // namespace evolving

#endif
