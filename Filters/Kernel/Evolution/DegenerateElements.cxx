// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/DegenerateElements.h"

#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/TopologySummary.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// In degrees: the scheme's errors grow with the cotangent, and remeshing gives thirty at once.
constexpr double DegenerateAngle = 20.0;
/// Between sharp edges that are to be rounded off first.
constexpr double CreasedAngle = 5.0;
/// Normals at a sharp edge have an angle of at least sixty degrees: this cosine.
constexpr double SharpCosine = 0.5;
/// Of all edges: the folds of a scan are fewer, the sharp edges of a machined part more.
constexpr double CreasedPart = 0.01;
/// In edge lengths: the longest edge of an element that is small.
constexpr double SmallElement = 2.0;
/// As many as an icosphere of level 4 has: edges of four degrees, as smooth as it looks.
constexpr double LeastVertices = 2562.0;
/// Of the vertices that a surface should have: edges twice as long.
constexpr double CoarsePart = 0.25;

bool hasBoundaryEdge(const SurfaceMesh& surface, const MeshTopology& topology, Index face)
{
  Index onBoundary = 0;
  for (Index k = 0; k < surface.faceSize(face); ++k)
  {
    onBoundary += topology.isBoundary(surface.faceVertex(face, k)) ? 1 : 0;
  }
  return onBoundary > 1;
}

bool isSmall(const SurfaceMesh& surface, Index face, double longest)
{
  for (Index k = 0; k < surface.faceSize(face); ++k)
  {
    const Index next = (k + 1) % surface.faceSize(face);
    if ((surface.facePoint(face, next) - surface.facePoint(face, k)).norm() > longest)
    {
      return false;
    }
  }
  return true;
}

/// Has it sharp edges, of elements that are small enough to round them off?
bool isCreased(const SurfaceMesh& surface, const MeshTopology& topology, double edgeLength)
{
  Index sharp = 0;
  for (Index corner = 0; corner < topology.cornerCount(); ++corner)
  {
    if (topology.opposite(corner) > corner)
    {
      const Index left = topology.faceOf(corner);
      const Index right = topology.faceOf(topology.opposite(corner));
      const Vec3 a = faceVectorArea(surface, left);
      const Vec3 b = faceVectorArea(surface, right);
      sharp += a.dot(b) < SharpCosine * a.norm() * b.norm() &&
          isSmall(surface, left, SmallElement * edgeLength) &&
          isSmall(surface, right, SmallElement * edgeLength)
        ? 1
        : 0;
    }
  }
  return sharp > CreasedPart * 0.5 * topology.cornerCount();
}

} // namespace

bool hasDegenerateElements(const SurfaceMesh& surface, BoundaryMode mode, double edgeLength)
{
  if (smallestAngle(surface) >= DegenerateAngle)
  {
    return false;
  }
  const MeshTopology topology(surface);
  const double least = isCreased(surface, topology, edgeLength) ? CreasedAngle : DegenerateAngle;
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const bool counts = mode == BoundaryMode::Free || !hasBoundaryEdge(surface, topology, face);
    if (counts && smallestAngle(surface, face) < least)
    {
      return true;
    }
  }
  return false;
}

bool isCoarse(const SurfaceMesh& surface, double wantedVertices)
{
  return summarizeTopology(surface).usedVertices < CoarsePart * wantedVertices;
}

double wantedVertices(const SurfaceMesh& start)
{
  return std::max<double>(summarizeTopology(start).usedVertices, LeastVertices);
}

} // namespace evolving
