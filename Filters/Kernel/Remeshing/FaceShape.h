// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How good a triangle is.
 */

#ifndef EVOLVING_FACE_SHAPE_H
#define EVOLVING_FACE_SHAPE_H

#include "Remeshing/EditableSurface.h"
#include "Types.h"

namespace evolving
{

/// 4 sqrt(3) area over the sum of squared lengths: 1 for an equilateral triangle, 0 without area.
double faceShape(const Vec3& a, const Vec3& b, const Vec3& c);

/// The cosine of the smallest angle: 1/2 for an equilateral triangle, 1 without area.
double cosineOfSmallestAngle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Is that of a triangle below a limit? The same answer, and mostly without a root.
bool hasSmallerCosine(const Vec3& a, const Vec3& b, const Vec3& c, double limit);

/// In degrees.
double smallestAngle(const Vec3& a, const Vec3& b, const Vec3& c);

///@{
/// Of a face.
double cosineOfSmallestAngle(const EditableSurface& surface, Index face);
double smallestAngle(const EditableSurface& surface, Index face);
///@}

/// Of all faces at a vertex, that of the smallest angle.
double cosineOfSmallestAngleAround(const EditableSurface& surface, Index vertex);

} // namespace evolving

#endif
