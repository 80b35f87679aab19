// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TriangleView.h"

#include "Errors.h"

#include <sstream>

namespace evolving
{

TriangleView triangleView(const SurfaceMesh& mesh)
{
  validate(mesh);
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (mesh.faceSize(face) != 3)
    {
      std::ostringstream message;
      message << "Face " << face << " has " << mesh.faceSize(face)
              << " corners, expected 3 to look for self-intersections; triangulate the mesh first.";
      throw InputError(message.str());
    }
  }
  return { mesh.points, mesh.cornerVertices };
}

} // namespace evolving
