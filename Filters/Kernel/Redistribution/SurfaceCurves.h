// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The curves of a surface that its vertices may slide along: boundary curves and sharp edges.
 */

#ifndef EVOLVING_SURFACE_CURVES_H
#define EVOLVING_SURFACE_CURVES_H

#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/// Vertices joined by edges, one after the other.
struct VertexChain
{
  std::vector<Index> vertices; ///< a closed chain does not repeat its first vertex
  bool isClosed = false;

  Index size() const { return static_cast<Index>(this->vertices.size()); }
  Index edgeCount() const { return this->isClosed ? this->size() : this->size() - 1; }
  /// Vertex k, counted round a closed chain.
  Index vertex(Index k) const
  {
    return this->vertices[static_cast<std::size_t>((k + this->size()) % this->size())];
  }
};

/// Where a curve turns by more than this, in degrees, is a corner. A regular decagon is a curve.
constexpr double DefaultCornerAngle = 40.0;

/**
 * The boundary and crease curves of a surface at its start. A vertex of exactly two curve edges
 * that meet at a small angle lies on a curve and can slide along it; all other vertices of curve
 * edges are corners and stay. Vertices slide along the polylines of the start, so that the
 * curves keep their shape.
 */
class SurfaceCurves
{
public:
  /// For every vertex its arc length along its curve; 0 off the curves.
  using Positions = std::vector<double>;

  /**
   * @param creaseAngle edges whose faces' normals differ by more than this, in degrees, are
   * curve edges besides the boundary, see curveNeighbours(); 180 for none
   * @param cornerAngle in degrees
   */
  SurfaceCurves(const SurfaceMesh& mesh, const MeshTopology& topology, double creaseAngle = 180.0,
    double cornerAngle = DefaultCornerAngle);

  /// Open chains end at corners.
  const std::vector<VertexChain>& chains() const { return this->Chains; }
  bool isOnCurve(Index vertex) const { return this->Roles[static_cast<std::size_t>(vertex)] > 0; }
  bool isCorner(Index vertex) const { return this->Roles[static_cast<std::size_t>(vertex)] == 2; }

  const Positions& startPositions() const { return this->Start; }

  /**
   * Slides the vertices on curves that are not corners.
   * @param velocity one per vertex; only its part along the curve counts
   * @param[in,out] positions of the vertices
   * @param[in,out] points changed at vertices that slide. No vertex goes farther than four
   * tenths of the way to its neighbour, so that their order along the curve stays.
   */
  void slide(const std::vector<Vec3>& velocity, double timeStep, Positions& positions,
    std::vector<Vec3>& points) const;

  /// Per vertex the unit tangent of its curve; zero at corners and off the curves.
  std::vector<Vec3> tangents(const std::vector<Vec3>& points) const;

private:
  void trace(const SurfaceMesh& mesh, const std::vector<std::vector<Index>>& neighbours);
  void measure(const SurfaceMesh& mesh);
  /// Of the vertices of a chain and its end, increasing.
  std::vector<double> positionsAlong(std::size_t chain, const Positions& positions) const;
  Vec3 pointAt(std::size_t chain, double position) const;

  std::vector<VertexChain> Chains;
  std::vector<std::vector<Vec3>> Polylines;    ///< the start's points along every chain
  std::vector<std::vector<double>> ArcLengths; ///< of the polylines' points, the end included
  std::vector<char> Roles;                     ///< 0 off the curves, 1 on a curve, 2 corner
  Positions Start;
};

} // namespace evolving

#endif
