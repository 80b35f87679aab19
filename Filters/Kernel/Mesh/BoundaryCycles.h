// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The simple closed curves of boundary edges of a mesh in any state.
 */

#ifndef EVOLVING_BOUNDARY_CYCLES_H
#define EVOLVING_BOUNDARY_CYCLES_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// An edge that belongs to one face only, as that face runs along it.
struct RimEdge
{
  Index from;
  Index to;
  Index face;

  Index otherEnd(Index vertex) const { return vertex == this->from ? this->to : this->from; }
};

/// A simple closed curve: edge k joins vertex k to the next one, in either direction.
struct RimCycle
{
  std::vector<Index> vertices;
  std::vector<RimEdge> edges;
};

/**
 * A walk along boundary edges cuts off a cycle whenever it returns to a vertex it has passed, so
 * that every cycle is simple, also where several boundary curves meet in a vertex. Which edges
 * belong together is unique unless two curves meet in more than one vertex. Chains that close
 * nowhere, as between edges of three faces, are left out. Orientation does not matter.
 */
std::vector<RimCycle> boundaryCycles(const SurfaceMesh& mesh);

} // namespace evolving

#endif
