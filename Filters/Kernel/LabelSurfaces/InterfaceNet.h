// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The faces between voxels of different materials, as a net of quads that all labels share.
 */

#ifndef EVOLVING_INTERFACE_NET_H
#define EVOLVING_INTERFACE_NET_H

#include "Execution.h"
#include "LabelSurfaces/MaterialGrid.h"
#include "Types.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace evolving
{

/// What meets at a vertex.
enum class VertexKind : std::uint8_t
{
  Sheet, ///< two materials: it lies within an interface
  Curve, ///< more, and two edges of three or more quads: it lies within a curve where they meet
  Node   ///< more, and another number of such edges: curves end or cross there
};

/// A voxel's face.
struct NetQuad
{
  std::array<Index, 4> vertices;   ///< counter-clockwise seen from the second side
  std::array<Material, 2> sides;   ///< of the voxels before and behind it along the axis
  std::array<GridIndex, 2> voxels; ///< their numbers in the grid
};

/**
 * One vertex at each corner of voxels that a face of the net has; all in units of voxels, with
 * voxel (0, 0, 0) about the origin. Vertices ascend along x, then y, then z.
 *
 * Boxes of half a voxel around the corners of different vertices do not overlap, and a quad whose
 * vertices stay in theirs lies in these and those of their common neighbours; so such quads cannot
 * meet where they have no vertex in common.
 */
struct InterfaceNet
{
  std::vector<std::array<Index, 3>> corners; ///< of every vertex
  std::vector<Vec3> points;
  std::vector<VertexKind> kinds;
  std::vector<std::uint8_t> fixed; ///< bit a: the vertex keeps its coordinate a, at the image's end
  std::vector<NetQuad> quads;

  /// The edges of vertex i are edgeOffsets[i] ... edgeOffsets[i + 1] - 1: their other ends,
  /// ascending, and whether three materials or more, or two of them twice, meet there.
  std::vector<Index> edgeOffsets{ 0 };
  std::vector<Index> edgeEnds;
  std::vector<char> isJunction;

  /// The quads of vertex i are quadOffsets[i] ... quadOffsets[i + 1] - 1 of quadsOfVertices.
  std::vector<Index> quadOffsets{ 0 };
  std::vector<Index> quadsOfVertices;

  Index vertexCount() const { return static_cast<Index>(this->points.size()); }
  Index quadCount() const { return static_cast<Index>(this->quads.size()); }
  /// Where a vertex is before anything moves.
  Vec3 cornerPoint(Index vertex) const
  {
    const std::array<Index, 3>& corner = this->corners[at(vertex)];
    return Vec3(corner[0] - 0.5, corner[1] - 0.5, corner[2] - 0.5);
  }
};

/// @throws InputError when there are more faces than an Index counts @throws Cancelled
InterfaceNet interfaceNet(const MaterialGrid& grid, const Execution& execution);

inline bool isSheet(const InterfaceNet& net, Index vertex)
{
  return net.kinds[at(vertex)] == VertexKind::Sheet;
}

/// Does a vertex lie where sheets meet, within the image?
inline bool isInnerJunction(const InterfaceNet& net, Index vertex)
{
  return !isSheet(net, vertex) && net.fixed[at(vertex)] == 0;
}

/// Does it lie where they meet in a side of the image?
inline bool isOutline(const InterfaceNet& net, Index vertex)
{
  return !isSheet(net, vertex) && net.fixed[at(vertex)] != 0;
}

/// The materials at both sides of a quad, the smaller one first: sheets are told apart by them.
inline std::array<Material, 2> sortedSides(const NetQuad& quad)
{
  return { std::min(quad.sides[0], quad.sides[1]), std::max(quad.sides[0], quad.sides[1]) };
}

/// The area vector of a quad: half the product of its diagonals.
inline Vec3 quadArea(const InterfaceNet& net, const std::vector<Vec3>& points, Index quad)
{
  const std::array<Index, 4>& v = net.quads[at(quad)].vertices;
  return 0.5 * (points[at(v[2])] - points[at(v[0])]).cross(points[at(v[3])] - points[at(v[1])]);
}

} // namespace evolving

#endif
