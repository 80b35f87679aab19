// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/SurfacePatches.h"

#include "Mesh/DisjointSets.h"

#include <utility>

namespace evolving
{

namespace
{

/// Roots, the smallest members of sets, renamed 0, 1, ... in ascending order.
TriangleLabels numbered(std::vector<Index> roots)
{
  TriangleLabels labels;
  labels.ofTriangle = std::move(roots);
  for (std::size_t face = 0; face < labels.ofTriangle.size(); ++face)
  {
    Index& label = labels.ofTriangle[face];
    // The root is the smallest member, so it has its number already.
    label = label == static_cast<Index>(face) ? labels.count++
                                              : labels.ofTriangle[static_cast<std::size_t>(label)];
  }
  return labels;
}

} // namespace

TriangleLabels connectedSets(
  const TargetTriangles& target, const SharpEdges& sharp, const std::vector<Index>& names)
{
  DisjointSets sets(names.size());
  for (Index face = 0; face < target.mesh().faceCount(); ++face)
  {
    forEachSmoothNeighbour(target, sharp, face,
      [&](Index other, Index)
      {
        if (names[static_cast<std::size_t>(face)] == names[static_cast<std::size_t>(other)])
        {
          sets.join(face, other);
        }
      });
  }
  std::vector<Index> roots(names.size());
  for (std::size_t face = 0; face < names.size(); ++face)
  {
    roots[face] = sets.find(static_cast<Index>(face));
  }
  return numbered(std::move(roots));
}

TriangleLabels surfacePatches(const TargetTriangles& target, const SharpEdges& sharp)
{
  const std::vector<Index> sameName(static_cast<std::size_t>(target.mesh().faceCount()), 0);
  return connectedSets(target, sharp, sameName);
}

} // namespace evolving
