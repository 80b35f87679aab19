// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Tori, tubes with two ends, and one-sided surfaces.
 */

#ifndef EVOLVING_TESTING_TUBES_H
#define EVOLVING_TESTING_TUBES_H

#include "Mesh/SurfaceMesh.h"

#include <functional>

namespace evolving::shapes
{

/// A torus around z: around segments along the ring, across around the tube; valence 6.
SurfaceMesh torus(Index around, Index across, double ringRadius, double tubeRadius);

/// The same points joined to quads; valence 4.
SurfaceMesh quadTorus(Index around, Index across, double ringRadius, double tubeRadius);

/// A tube around z from -height to height: radius(z), triangles, two boundary circles.
SurfaceMesh tube(
  Index around, Index along, double height, const std::function<double(double)>& radius);

/// The side of a cylinder about the z axis, without its ends.
SurfaceMesh openCylinder(Index around, Index rows, double radius, double height);

/// A strip of count quads about the circle of a radius, closed after half a turn.
SurfaceMesh moebiusBand(Index count, double radius = 2.0, double halfWidth = 0.5);

/// A tube of triangles, its section a figure eight, closed after half a turn: no sides.
SurfaceMesh kleinBottle(Index around, Index across);

} // namespace evolving::shapes

#endif
