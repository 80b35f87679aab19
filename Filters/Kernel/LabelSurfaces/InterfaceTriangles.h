// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The triangles of a net: they are the interfaces that labels share.
 */

#ifndef EVOLVING_INTERFACE_TRIANGLES_H
#define EVOLVING_INTERFACE_TRIANGLES_H

#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// Triangles between vertices of a net, each a part of one of its quads, or come from one, and
/// oriented as that.
struct InterfaceTriangles
{
  std::vector<Index> corners; ///< three vertices for each
  std::vector<Index> quads;   ///< the quad of each, whose sides are its own

  Index count() const { return static_cast<Index>(this->quads.size()); }
};

/**
 * Splits every quad along the diagonal that leaves the larger smallest angle: quad q becomes the
 * triangles 2 q and 2 q + 1.
 * @param points of the vertices, where angles count
 */
InterfaceTriangles splitNet(
  const InterfaceNet& net, const std::vector<Vec3>& points, const Execution& execution);

/// The corners of triangles at every vertex, ascending: those of vertex i are
/// corners[offsets[i]] ... corners[offsets[i + 1] - 1].
struct CornersOfVertices
{
  std::vector<Index> offsets;
  std::vector<Index> corners;
};

CornersOfVertices cornersOfVertices(const InterfaceTriangles& triangles, Index vertexCount);

/// An edge by its ends, the smaller one first.
using NetEdge = std::array<Index, 2>;

/**
 * Puts a new vertex into the middle of edges, and cuts the triangles there.
 * @param edges sorted; edge e gets vertex `first` + e
 */
void splitEdges(const std::vector<NetEdge>& edges, Index first, InterfaceTriangles& triangles);

} // namespace evolving

#endif
