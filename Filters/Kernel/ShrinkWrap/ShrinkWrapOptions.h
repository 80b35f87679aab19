// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The parameters of shrink-wrapping.
 */

#ifndef EVOLVING_SHRINK_WRAP_OPTIONS_H
#define EVOLVING_SHRINK_WRAP_OPTIONS_H

#include <array>
#include <tuple>

namespace evolving
{

/// Where the evolution starts.
enum class WrapStart
{
  Isosurface = 0, ///< of the distance, a little outside: has the target's holes and handles
  Icosphere = 1,  ///< a sphere around the target, as in the thesis
};

/// Whether edges and vertices come to lie on creases and corners of the target.
enum class FeaturePreservation
{
  Off = 0,
  On = 1,
  Automatic = 2, ///< on those parts whose sharp edges are creases: keepDistinctCreases()
};

/// The range of targetNumberOfPoints: more would take hours.
constexpr int MostPointsToAskFor = 1000000;

struct ShrinkWrapOptions
{
  WrapStart start = WrapStart::Isosurface;
  std::array<int, 3> sampleDimensions = { 0, 0, 0 }; ///< 0 = automatic, see WrapResolution.h
  double targetEdgeLength = 0.0;                     ///< 0 = from the number of points
  int targetNumberOfPoints = 0; ///< 0 = automatic; of no use with a target edge length
  /// Diameter of the gaps to close; 0 = those that the start surface cannot enter, an edge length
  /// or 1.6 cells wide, and wider cracks where without them nearly nothing would be inside.
  double gapSize = 0.0;
  bool adaptToCurvature = false; ///< as many elements, smaller ones where the target is curved
  FeaturePreservation preserveFeatures = FeaturePreservation::Automatic;
  double featureAngle = 45.0;  ///< degrees between normals from which an edge is a crease
  int numberOfSteps = 0;       ///< 0 = as many as the start needs
  double offsetDistance = 0.0; ///< of the result from the target, outwards
};

/// All of them: a new one does not compile before it is listed here.
inline auto membersOf(const ShrinkWrapOptions& options)
{
  const auto& [start, sampleDimensions, targetEdgeLength, targetNumberOfPoints, gapSize,
    adaptToCurvature, preserveFeatures, featureAngle, numberOfSteps, offsetDistance] = options;
  return std::tie(start, sampleDimensions, targetEdgeLength, targetNumberOfPoints, gapSize,
    adaptToCurvature, preserveFeatures, featureAngle, numberOfSteps, offsetDistance);
}

bool operator==(const ShrinkWrapOptions& a, const ShrinkWrapOptions& b);

/**
 * @throws InputError for lengths that are negative, not finite or above 1e31, an edge length below
 * 1e-31 that is not 0, and numbers out of range
 */
void checkOptions(const ShrinkWrapOptions& options);

/// The number of steps, resolved.
int stepsOf(const ShrinkWrapOptions& options);

/// The time step of the flow; like the number of steps it follows from options alone.
double timeStepOf(const ShrinkWrapOptions& options);

/// Covers the area with so many vertices. Of a wire or a needle, which has next to no area, so long
/// that the wall around it has about as many.
double edgeLengthFor(double vertexCount, double area, double length);

/// edgeLengthFor() 9000 vertices: a four-hundredth of a needle's length.
double defaultEdgeLength(double area, double length);

} // namespace evolving

#endif
