// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The connected components of a surface, and which of them lies inside which.
 */

#ifndef EVOLVING_COMPONENT_NESTING_H
#define EVOLVING_COMPONENT_NESTING_H

#include "Mesh/SurfaceMesh.h"
#include "Mesh/TriangleEdges.h"
#include "Types.h"

#include <vector>

namespace evolving
{

struct SurfaceComponent
{
  Box box;
  double area = 0.0;
  double volume = 0.0;   ///< signed, about the centre of the box
  bool isClosed = false; ///< do its directed faces cancel along every edge?
  Index largestFace = NoIndex;
};

/**
 * @param mesh of triangles only
 * @param componentOfFace in [0, count)
 */
std::vector<SurfaceComponent> surfaceComponents(const SurfaceMesh& mesh, const TriangleEdges& edges,
  const std::vector<Index>& componentOfFace, Index count);

/// Do the boxes of two components have a point in common?
bool boxesIntersect(const std::vector<SurfaceComponent>& components);

/**
 * For every closed component the closed component that encloses it and is enclosed by none,
 * by the boxes and the parity of a ray from a point of it; itself when nothing encloses it, or
 * it is open. A component whose box sticks out of another's overlaps it at most.
 */
std::vector<Index> outermostEnclosing(const SurfaceMesh& mesh,
  const std::vector<SurfaceComponent>& components, const std::vector<Index>& componentOfFace);

} // namespace evolving

#endif
