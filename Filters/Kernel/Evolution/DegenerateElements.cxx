// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/DegenerateElements.h"

#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// In degrees: the scheme's errors grow with the cotangent, and remeshing gives thirty at once.
constexpr double DegenerateAngle = 20.0;
/// As many as an icosphere of level 4 has: edges of four degrees, as smooth as it looks.
constexpr double LeastVertices = 2562.0;

bool hasBoundaryEdge(const SurfaceMesh& surface, const MeshTopology& topology, Index face)
{
  Index onBoundary = 0;
  for (Index k = 0; k < surface.faceSize(face); ++k)
  {
    onBoundary += topology.isBoundary(surface.faceVertex(face, k)) ? 1 : 0;
  }
  return onBoundary > 1;
}

} // namespace

bool hasDegenerateElements(const SurfaceMesh& surface, BoundaryMode mode)
{
  if (smallestAngle(surface) >= DegenerateAngle)
  {
    return false;
  }
  const MeshTopology topology(surface);
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const bool counts = mode == BoundaryMode::Free || !hasBoundaryEdge(surface, topology, face);
    if (counts && smallestAngle(surface, face) < DegenerateAngle)
    {
      return true;
    }
  }
  return false;
}

double coveringEdgeLength(const SurfaceMesh& surface)
{
  const MeshTopology topology(surface);
  double vertices = 0.0;
  for (Index v = 0; v < surface.vertexCount(); ++v)
  {
    vertices += topology.isUsed(v) ? 1.0 : 0.0;
  }
  return std::sqrt(
    2.0 * surfaceArea(surface) / (std::sqrt(3.0) * std::max(vertices, LeastVertices)));
}

} // namespace evolving
