// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Chains of opposite edges through the regular vertices of a mesh: its grid lines.
 */

#ifndef EVOLVING_EDGE_CHAINS_H
#define EVOLVING_EDGE_CHAINS_H

#include "Mesh/MeshTopology.h"
#include "Redistribution/SurfaceCurves.h"

#include <vector>

namespace evolving
{

/// The longest chain, in edges: on some meshes a chain winds round the whole surface.
constexpr Index LongestChain = 10000;

/**
 * Inner vertices of six triangles or of four quads are regular: an edge that arrives there goes
 * on as the opposite one. A chain ends at irregular vertices, on curves, before an edge already
 * in it, and after LongestChain edges; one that returns to its beginning is closed. Every edge
 * that is no boundary edge is in one chain.
 */
std::vector<VertexChain> edgeChains(const MeshTopology& topology, const SurfaceCurves& curves);

} // namespace evolving

#endif
