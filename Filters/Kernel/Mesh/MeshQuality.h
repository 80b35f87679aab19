// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How good the elements of a mesh are.
 */

#ifndef EVOLVING_MESH_QUALITY_H
#define EVOLVING_MESH_QUALITY_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * The smallest angle in degrees between consecutive edges of a face; 0 for a face with a vanishing
 * edge. Corners where a polygon is concave count with the angle outside.
 */
double smallestAngle(const SurfaceMesh& mesh, Index face);

/// Angles in degrees over all faces; all zero for a mesh without faces.
struct AngleSummary
{
  double smallest = 0.0;
  double firstPercentile = 0.0; ///< of the faces' smallest angles
  double mean = 0.0;            ///< of the faces' smallest angles
};

AngleSummary summarizeAngles(const SurfaceMesh& mesh);

/// The smallest corner angle of all faces in degrees; 0 when an edge has no length.
double smallestAngle(const SurfaceMesh& mesh, const Execution& execution = {});

/// The mean length of the edges, each counted once per face.
double meanEdgeLength(const SurfaceMesh& mesh);

} // namespace evolving

#endif
