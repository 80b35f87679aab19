// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Shapes with known creases.
 */

#ifndef EVOLVING_TESTING_CREASED_SHAPES_H
#define EVOLVING_TESTING_CREASED_SHAPES_H

#include "Mesh/SurfaceMesh.h"

#include <random>
#include <vector>

namespace evolving::shapes
{

/// A prism of triangles over a simple polygon in the plane z = 0, counter-clockwise.
SurfaceMesh extruded(const std::vector<Vec3>& polygon, double height);

std::vector<Vec3> regularPolygon(int count, double radius = 1.0);

/// Star-shaped about the origin, with corners of all angles.
std::vector<Vec3> randomPolygon(std::mt19937& generator);

/// A prism over a triangle.
SurfaceMesh wedge();

/// A prism over a triangle with a right angle at (length, 0), and an acute one at the origin: its
/// edge there is as sharp as a knife.
SurfaceMesh blade(double degrees, double length, double height);

/// A prism over an L.
SurfaceMesh ell();

/// A prism over 48 corners of a circle.
SurfaceMesh cylinder();

/// Radius and height 1: no crease leads to the apex.
SurfaceMesh cone();

/// Over a regular polygon of radius 1: vertex 0 is the tip, around which there are so many degrees
/// in all, vertex 1 the middle of the base, then come the corners; faces 0, 2, ... are the sides.
SurfaceMesh pyramid(Index sides, double degreesAround);

/**
 * A box whose top falls off to both sides of a ridge that ends in its middle: from there a fold of
 * 77 degrees runs to the middle of one side, all others on the top are below 30.
 */
SurfaceMesh boxWithDart();

/// A cube with an edge cut off that leaves less room than an element needs.
SurfaceMesh chamferedCube(double width);

/// Along y = 0 a ridge that fades out from x = -1 to x = 1: its fold is 2 atan((1 - x) / 2).
SurfaceMesh fadingRidge(Index count);

/// Along y = 0 a valley that begins and ends inside.
SurfaceMesh pressedWedge(Index count);

} // namespace evolving::shapes

#endif
