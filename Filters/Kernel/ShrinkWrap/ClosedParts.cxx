// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ClosedParts.h"

#include "Mesh/SurfaceParts.h"

namespace evolving
{

std::vector<char> facesOfClosedParts(const SurfaceMesh& surface, double thickness)
{
  const SurfaceParts parts = surfaceParts(surface);
  std::vector<char> isClosed(at(surface.faceCount()), 0);
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const SurfacePart& part = parts.list[at(parts.ofFace[at(face)])];
    isClosed[at(face)] =
      part.isClosed && part.meanThickness() > thickness && !usesAPointTwice(surface, face);
  }
  return isClosed;
}

} // namespace evolving
