// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The pieces that sharp edges cut a surface into.
 */

#ifndef EVOLVING_SURFACE_PATCHES_H
#define EVOLVING_SURFACE_PATCHES_H

#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// Triangles and the set each belongs to; sets are numbered by their smallest triangle.
struct TriangleLabels
{
  std::vector<Index> ofTriangle;
  Index count = 0;

  Index operator[](Index face) const { return this->ofTriangle[static_cast<std::size_t>(face)]; }
};

/// Sets cut into connected ones: over edges that are not sharp, between triangles of one name.
TriangleLabels connectedSets(
  const TargetTriangles& target, const SharpEdges& sharp, const std::vector<Index>& names);

/// Triangles belong together when one is reached from the other over edges that are not sharp.
TriangleLabels surfacePatches(const TargetTriangles& target, const SharpEdges& sharp);

/// Calls visit(neighbour, edge) for the triangles beyond those edges of a face that are not sharp.
template <typename Visit>
void forEachSmoothNeighbour(
  const TargetTriangles& target, const SharpEdges& sharp, Index face, const Visit& visit)
{
  for (Index k = 0; k < 3; ++k)
  {
    const Index edge = target.edgeOfFace(face, k);
    if (!sharp.isSharp(edge))
    {
      target.forEachFaceAcross(face, k, [&](Index other) { visit(other, edge); });
    }
  }
}

} // namespace evolving

#endif
