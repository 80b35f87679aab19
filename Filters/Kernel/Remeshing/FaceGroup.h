// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Questions about faces, one or a group, before and after some of their corners move.
 */

#ifndef EVOLVING_FACE_GROUP_H
#define EVOLVING_FACE_GROUP_H

#include "Remeshing/EditableSurface.h"
#include "Trees/TriangleGeometry.h"
#include "Types.h"

#include <cstddef>
#include <vector>

namespace evolving
{

/// A face as it is.
Triangle triangleOf(const EditableSurface& surface, Index f);

/// The normals of the faces, each twice its area long.
std::vector<Vec3> areasOf(const EditableSurface& surface, const std::vector<Index>& faces);

/// Has no face turned by more than 45 degrees? @param before areasOf() the same faces
bool areUpright(
  const EditableSurface& surface, const std::vector<Index>& faces, const std::vector<Vec3>& before);

/// Different when a corner is elsewhere, all but certainly.
std::size_t fingerprintOf(const EditableSurface& surface, const std::vector<Index>& faces);

/// In degrees; 60 of no faces.
double smallestAngleOf(const EditableSurface& surface, const std::vector<Index>& faces);

} // namespace evolving

#endif
