// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Good surfaces with needles and caps put in.
 */

#ifndef EVOLVING_TESTING_SLIVERS_H
#define EVOLVING_TESTING_SLIVERS_H

#include "Mesh/SurfaceMesh.h"
#include "Remeshing/EditableSurface.h"

namespace evolving::shapes
{

/// A face split at the midpoint of its first edge moved inwards, by a part of the way to the apex:
/// a cap, and a vertex with three neighbours.
inline SurfaceMesh withCap(const SurfaceMesh& mesh, Index face, double inwards)
{
  SurfaceMesh result;
  result.points = mesh.points;
  const Vec3 middle = 0.5 * (mesh.facePoint(face, 0) + mesh.facePoint(face, 1));
  const Index added = mesh.vertexCount();
  result.addPoint(middle + inwards * (mesh.facePoint(face, 2) - middle));
  for (Index f = 0; f < mesh.faceCount(); ++f)
  {
    const Index a = mesh.faceVertex(f, 0);
    const Index b = mesh.faceVertex(f, 1);
    const Index c = mesh.faceVertex(f, 2);
    if (f != face)
    {
      result.addFace({ a, b, c });
      continue;
    }
    result.addFace({ a, b, added });
    result.addFace({ b, c, added });
    result.addFace({ c, a, added });
  }
  return result;
}

/// Every n-th edge split close to one of its ends, at a part of its length: needles, as where a
/// contour passes close to a sample.
inline SurfaceMesh withNeedles(const SurfaceMesh& mesh, Index n, double part)
{
  EditableSurface surface(mesh);
  const Index edges = surface.edgeSlots();
  for (Index e = 0; e < edges; e += n)
  {
    const Vec3& from = surface.point(surface.from(e));
    surface.split(e, from + part * (surface.point(surface.to(e)) - from));
  }
  return surface.mesh();
}

} // namespace evolving::shapes

#endif
