// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What tests measure of a surface: how far it is from where it should be, and how even it is.
 */

#ifndef EVOLVING_TESTING_SURFACE_MEASURES_H
#define EVOLVING_TESTING_SURFACE_MEASURES_H

#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving::checks
{

bool areFinite(const std::vector<double>& values);
bool areFinite(const std::vector<Vec3>& values);

/// Standard deviation over mean.
double relativeSpread(const std::vector<double>& values);

/// Of the points' distances from the origin.
double meanRadius(const SurfaceMesh& mesh);

/// The largest difference of a point's distance from the origin to a radius.
double largestRadialError(const SurfaceMesh& mesh, double radius);

/// The root of the mean squared distance of points from a surface.
double rmsDistance(const std::vector<Vec3>& points, const SurfaceMesh& surface);

/// The largest distance of any point of a surface, or a sample of it, from another.
double farthest(const SurfaceMesh& from, const SurfaceMesh& to, double spacing);

/// The larger one of both ways.
double hausdorff(const SurfaceMesh& a, const SurfaceMesh& b, double spacing);

} // namespace evolving::checks

#endif
