// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A triangle in its own plane: how far is it from many points at once?
 */

#ifndef EVOLVING_FRAMED_TRIANGLE_H
#define EVOLVING_FRAMED_TRIANGLE_H

#include "Trees/TriangleGeometry.h"
#include "Types.h"

namespace evolving
{

/**
 * The longest edge runs from the anchor along the first axis, the opposite corner lies on the
 * positive side of the second, the third is the normal. A point is taken to the anchor in double
 * and measured from there in float: however far both are from the origin, the squared distance is
 * good to some 1e-6 of itself plus (1e-7 of the longest edge) squared.
 */
struct FramedTriangle
{
  /// An edge in the plane: a direction, and where the point at its beginning comes to lie.
  struct Edge
  {
    float directionX = -1.0F;
    float directionY = 0.0F;
    float length = 0.0F;
    float beginAlong = 0.0F;  ///< of the edge's beginning along its direction
    float beginBeside = 0.0F; ///< to the left of it
  };

  /// A shorter edge is none: its square would be a number of few digits, its direction no unit
  /// vector.
  static constexpr double ShortestEdge = 1e-150;

  double anchor[3] = { 0.0, 0.0, 0.0 };
  float along[3] = { 1.0F, 0.0F, 0.0F };
  float beside[3] = { 0.0F, 1.0F, 0.0F };
  float normal[3] = { 0.0F, 0.0F, 1.0F };
  float length = 0.0F; ///< of the longest edge
  float height = 0.0F; ///< over it
  Edge second;         ///< from the end of the longest edge to the opposite corner
  Edge third;          ///< from there back to the anchor
  Index number = NoIndex;

  FramedTriangle() = default;
  /// @param number the triangle's, kept
  FramedTriangle(const Triangle& triangle, Index number);
};

} // namespace evolving

#endif
