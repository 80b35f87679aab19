// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What is left of a damaged mesh when its damaged faces are taken out.
 */

#ifndef EVOLVING_USABLE_PART_H
#define EVOLVING_USABLE_PART_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <string>
#include <vector>

namespace evolving
{

/// Faces, or points of a mesh without faces, that cannot be used.
struct DamagedParts
{
  Index notFinite = 0;     ///< with a coordinate that is not a finite number
  Index tooFewCorners = 0; ///< faces with fewer than three
  Index first = NoIndex;   ///< the first of them

  Index count() const { return this->notFinite + this->tooFewCorners; }
};

/// @param mesh whose vertex numbers are all in range
DamagedParts findDamagedParts(const SurfaceMesh& mesh);

/**
 * The mesh without its damaged faces; all points stay, with their numbers. A mesh without faces
 * loses its points that are not finite.
 * @param[out] oldNumber when not null, of every face that is left, or of every point of a mesh
 * without faces, the old number
 */
SurfaceMesh withoutDamagedParts(const SurfaceMesh& mesh, std::vector<Index>* oldNumber = nullptr);

/**
 * One sentence that says what was left out of a mesh.
 * @param first the name of the first of them, as the user knows it
 */
std::string describeLeftOut(
  const DamagedParts& damaged, const SurfaceMesh& mesh, const std::string& first);

} // namespace evolving

#endif
