// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The shapes of elements, and where between its neighbours a vertex makes them best.
 */

#ifndef EVOLVING_ELEMENT_SHAPE_H
#define EVOLVING_ELEMENT_SHAPE_H

#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

namespace evolving
{

/**
 * The shape of a corner: the squared lengths against the area of the map that takes the corner of
 * a regular polygon to it; 1 for that corner, growing without bound as it degenerates, independent
 * of size. For a triangle it is (a^2 + b^2 + c^2) / (4 sqrt(3) area), the inverse mean ratio of
 * Knupp, *Algebraic mesh quality metrics*, 2001.
 * @param e1 edge to the next corner
 * @param e2 edge to the previous corner
 * @param faceSize corners of the face
 */
double cornerShape(const Vec3& e1, const Vec3& e2, Index faceSize);

/**
 * The way from a vertex to the place between its neighbours where the corners that it takes part in
 * have the best shapes: a Newton step for the sum of their squares, in the tangent plane, or along
 * the curve of a vertex that lies on one. Squares, because a bad element is to weigh more than
 * several good ones. The sum is convex where the elements lie in the tangent plane.
 *
 * Not in the thesis. Its angle-based velocity (3.24) lowers no such measure: it improves most
 * elements at the expense of some.
 * @param normal of the tangent plane, a unit vector, or zero for that of the faces around
 * @param tangent of the curve, a unit vector; zero off the curves
 */
Vec3 bestShapeMove(const SurfaceMesh& mesh, const MeshTopology& topology, Index vertex,
  const Vec3& normal, const Vec3& tangent);

} // namespace evolving

#endif
