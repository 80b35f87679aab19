// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What a surface of triangles is worth for computing: angles, shapes and areas of its elements.
 */

#ifndef BENCHMARK_ELEMENT_QUALITY_H
#define BENCHMARK_ELEMENT_QUALITY_H

#include "Mesh/SurfaceMesh.h"

namespace benchmark
{

/// Angles in degrees; a face counts with its smallest one.
struct ElementQuality
{
  double smallestAngle = 0.0;
  double firstPercentile = 0.0; ///< of the angles, between two faces by interpolation
  double meanAngle = 0.0;
  double partBelow30 = 0.0; ///< of the faces
  double radiusRatio = 0.0; ///< twice the inner by the outer radius, the mean; 1: equilateral
  ///@{
  /// Standard deviation by mean. Co-volumes are what the volume-based redistribution makes equal:
  /// areas differ all the same around points of different valence.
  double areaSpread = 0.0;
  double coVolumeSpread = 0.0;
  ///@}
};

/// @param mesh of triangles, at least one, that use every point
ElementQuality elementQuality(const evolving::SurfaceMesh& mesh);

} // namespace benchmark

#endif
