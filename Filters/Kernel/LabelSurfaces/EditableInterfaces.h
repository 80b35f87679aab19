// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A part of the triangles of a net, whose elements can be changed.
 */

#ifndef EVOLVING_EDITABLE_INTERFACES_H
#define EVOLVING_EDITABLE_INTERFACES_H

#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/InterfaceTriangles.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/**
 * The triangles at chosen vertices of a net, numbered by themselves. Sheets meet in curves, so an
 * edge has two triangles or more. Every label's surface stays a manifold of the same topology: an
 * edge collapses only where nothing but the edge and its triangles joins its ends in the surface of
 * any label (the link condition of Dey, Edelsbrunner, Guha and Nekhayev, *Topology preserving edge
 * contraction*, 1999). The background has no surface to keep.
 */
class EditableInterfaces
{
public:
  using Corners = std::array<Index, 3>;

  static bool hasCorner(const Corners& corners, Index vertex)
  {
    return corners[0] == vertex || corners[1] == vertex || corners[2] == vertex;
  }

  /// One for each vertex of the net.
  struct Part
  {
    const std::vector<char>& isChosen;  ///< those whose triangles are taken
    const std::vector<char>& isFree;    ///< those of them that changes may concern
    const std::vector<char>& isPinched; ///< where a label's surface may pass more than once
  };

  EditableInterfaces(const InterfaceNet& net, const InterfaceTriangles& triangles,
    const std::vector<Vec3>& places, const Part& part);

  Index vertexCount() const { return static_cast<Index>(this->Numbers.size()); }
  Index triangleCount() const { return static_cast<Index>(this->Triangles.size()); }
  /// Of a vertex in the net.
  Index netVertex(Index vertex) const { return this->Numbers[at(vertex)]; }
  VertexKind kind(Index vertex) const { return this->Kinds[at(vertex)]; }
  bool isFree(Index vertex) const { return this->Free[at(vertex)] != 0; }
  /// Is a vertex still there?
  bool isUsed(Index vertex) const { return !this->Stars[at(vertex)].empty(); }
  bool isAlive(Index triangle) const { return this->Alive[at(triangle)] != 0; }
  /// Counter-clockwise seen from the sheet's larger material.
  const Corners& corners(Index triangle) const { return this->Triangles[at(triangle)]; }
  const std::array<Material, 2>& sheet(Index triangle) const { return this->Sheets[at(triangle)]; }
  /// The triangles around a vertex; all of them if it was chosen.
  const std::vector<Index>& star(Index vertex) const { return this->Stars[at(vertex)]; }
  std::vector<Index> trianglesAt(Index a, Index b) const;
  std::vector<Index> neighbors(Index vertex) const;
  /// The other ends of the edges where sheets meet.
  std::vector<Index> curveNeighbors(Index vertex) const;

  const Vec3& place(Index vertex) const { return this->Places[at(vertex)]; }
  void move(Index vertex, const Vec3& place) { this->Places[at(vertex)] = place; }

  /// May a vertex go into another one, as far as the connectivity is concerned?
  bool canCollapse(Index from, Index to) const;
  void collapse(Index from, Index to);
  /// Does an edge lie within the sheet or on the curve that its first vertex lies on?
  bool isOwnEdge(Index from, Index to) const;
  /// The corners opposite to an edge that may be flipped; NoIndex otherwise.
  std::array<Index, 2> flipEnds(Index a, Index b) const;
  void flip(Index a, Index b);

  /// Changes the net's triangles and the points of its vertices to what they are here.
  void writeTo(InterfaceTriangles& triangles, std::vector<Vec3>& places) const;

private:
  bool canCollapse(Index from, Index to, Material label) const;
  std::vector<Material> labelsOf(const std::vector<Index>& triangles) const;
  std::vector<Index> starOf(Index vertex, Material label) const;
  std::vector<Index> neighborsIn(const std::vector<Index>& triangles, Index vertex) const;
  bool wouldDouble(Index from, Index to) const;
  bool isPassedTwice(Index a, Index b) const;
  bool areOneSheet(const std::vector<Index>& triangles) const;

  std::vector<Index> Numbers;
  std::vector<Vec3> Places;
  std::vector<VertexKind> Kinds;
  std::vector<char> Free;
  std::vector<char> Pinched;
  std::vector<std::vector<Index>> Stars;
  std::vector<Corners> Triangles;
  std::vector<Index> Sources; ///< of every triangle, its number in the net
  std::vector<std::array<Material, 2>> Sheets;
  std::vector<char> Turned; ///< of every triangle: it is seen from the other side in the net
  std::vector<char> Alive;
};

} // namespace evolving

#endif
