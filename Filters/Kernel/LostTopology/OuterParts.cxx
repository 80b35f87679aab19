// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LostTopology/OuterParts.h"

#include "Mesh/SurfaceParts.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// A ray from a part to the outside crosses each part around it an odd number of times.
bool isEnclosed(const SurfaceParts& parts, Index face, const AABBTree& tree)
{
  std::vector<char> isAround(parts.list.size(), 0);
  for (const RayHit& hit : tree.hits(Ray(tree.triangle(face).centroid(), askewDirection())))
  {
    isAround[at(parts.ofFace[at(hit.triangle)])] ^= 1;
  }
  isAround[at(parts.ofFace[at(face)])] = 0;
  return std::find(isAround.begin(), isAround.end(), 1) != isAround.end();
}

std::vector<char> enclosedParts(
  const SurfaceMesh& surface, const SurfaceParts& parts, const Execution& execution)
{
  std::vector<char> isPartEnclosed(parts.list.size(), 0);
  if (parts.list.size() < 2)
  {
    return isPartEnclosed;
  }
  const AABBTree tree(surface, execution);
  Index next = 0; // parts are numbered by their first faces
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    if (parts.ofFace[at(face)] == next)
    {
      isPartEnclosed[at(next)] = isEnclosed(parts, face, tree);
      ++next;
    }
  }
  return isPartEnclosed;
}

} // namespace

SurfaceMesh outerParts(const SurfaceMesh& surface, const Execution& execution)
{
  const SurfaceParts parts = surfaceParts(surface);
  const std::vector<char> isPartEnclosed = enclosedParts(surface, parts, execution);
  SurfaceMesh outer;
  outer.points = surface.points;
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const auto part = at(parts.ofFace[at(face)]);
    Index second = surface.faceVertex(face, 1);
    Index third = surface.faceVertex(face, 2);
    if (parts.list[part].sixVolumes < 0.0)
    {
      std::swap(second, third);
    }
    if (!isPartEnclosed[part])
    {
      outer.addFace({ surface.faceVertex(face, 0), second, third });
    }
  }
  return outer;
}

} // namespace evolving
