// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which corners of triangles are one vertex of a label's surface.
 */

#ifndef EVOLVING_SURFACE_PASSES_H
#define EVOLVING_SURFACE_PASSES_H

#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/InterfaceTriangles.h"
#include "Types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace evolving
{

/**
 * At every vertex, the triangles of a label around it are joined by the edges that they have in
 * common: two by two where there are four, those at the same voxel. What hangs together is one
 * pass of the label's surface through the vertex, and one vertex of that surface.
 */
class SurfacePasses
{
public:
  SurfacePasses(const InterfaceNet& net, const InterfaceTriangles& triangles, Index vertexCount,
    const Execution& execution);

  /// Of corner c of a triangle as one of side s (0, 1) of it; NoIndex where that is no label.
  Index pass(Index corner, Index side) const { return this->Passes[at(2 * corner + side)]; }
  /// Of every pass: its vertex and its label.
  const std::vector<Index>& vertices() const { return this->Vertices; }
  const std::vector<Material>& labels() const { return this->Labels; }

  /// The edges along which a label passes twice from one pass to one other, sorted.
  std::vector<NetEdge> ambiguousEdges(const Execution& execution) const;

private:
  /// A side of a triangle's corner that is one of a label.
  struct Wedge
  {
    Material label;
    Index corner;
    Index side;
    GridIndex voxel;           ///< of the label
    std::array<Index, 2> ends; ///< the triangle's other vertices
    Index pass;                ///< of those at its vertex
  };

  /// Of a vertex, joined.
  std::vector<Wedge> wedgesAt(Index vertex) const;
  static bool hasEnd(const Wedge& wedge, Index end);
  static std::ptrdiff_t countAlong(const std::vector<Wedge>& wedges, const Wedge& wedge, Index end);
  static bool areJoined(const std::vector<Wedge>& wedges, const Wedge& a, const Wedge& b);
  static void join(std::vector<Wedge>& wedges);

  void renumberAt(Index vertex, Index offset);
  const NetQuad& quadOf(Index corner) const;
  Index passAtEnd(const Wedge& wedge, Index end) const;
  bool isAmbiguous(const std::vector<Wedge>& wedges, const Wedge& wedge, Index end) const;

  const InterfaceNet& Net;
  const InterfaceTriangles& Triangles;
  CornersOfVertices Corners;
  std::vector<Index> Passes;
  std::vector<Index> Vertices;
  std::vector<Material> Labels;
};

} // namespace evolving

#endif
