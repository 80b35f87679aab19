// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The connected pieces of a mesh.
 */

#ifndef EVOLVING_CONNECTED_COMPONENTS_H
#define EVOLVING_CONNECTED_COMPONENTS_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// Vertices are connected when a face has both.
struct ConnectedComponents
{
  /// The component of every vertex, numbered by smallest vertex; NoIndex for unused vertices.
  std::vector<Index> ofVertex;
  Index count = 0;
};

ConnectedComponents connectedComponents(const SurfaceMesh& mesh);

} // namespace evolving

#endif
