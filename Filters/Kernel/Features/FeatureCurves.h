// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The sharp edges of a surface as a graph: corners, and curves between them.
 */

#ifndef EVOLVING_FEATURE_CURVES_H
#define EVOLVING_FEATURE_CURVES_H

#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// Sharp edges one after the other.
struct FeatureCurve
{
  std::vector<Index> edges;
  std::vector<Index> vertices; ///< along the edges; a closed curve repeats its first at the end
  bool isClosed = false;       ///< without any corner
  double length = 0.0;
  double fold = 0.0; ///< the mean along the curve of SharpEdges::fold(), in degrees
};

/**
 * A vertex is a corner when it has one sharp edge (a loose end), more than two, or two that turn
 * by more than CornerAngle, so that a regular hexagon is a closed curve. Every sharp edge belongs
 * to one curve; a curve runs from corner to corner (which may be the same one) or is closed.
 */
class FeatureCurves
{
public:
  static constexpr double CornerAngle = 60.01; ///< in degrees

  FeatureCurves(const TargetTriangles& target, const SharpEdges& sharp);

  const std::vector<FeatureCurve>& curves() const { return this->Curves; }
  /// The vertices that are corners, ascending.
  const std::vector<Index>& corners() const { return this->Corners; }
  bool isCorner(Index vertex) const { return this->Roles[at(vertex)] == Role::Corner; }
  /// How many sharp edges a vertex has.
  Index valence(Index vertex) const;
  /// The curve of an edge; NoIndex when it is not sharp.
  Index curveOf(Index edge) const { return this->CurveOfEdge[at(edge)]; }

private:
  enum class Role : char
  {
    None,
    Curve,
    Corner
  };

  void sortByVertex(const TargetTriangles& target, const std::vector<Index>& edges);
  Role roleOf(const TargetTriangles& target, Index vertex) const;
  void trace(const TargetTriangles& target, const SharpEdges& sharp, Index start, Index edge);
  Index otherEdge(Index vertex, Index edge) const;

  std::vector<Index> EdgeOffsets; ///< per vertex, into EdgesOfVertices
  std::vector<Index> EdgesOfVertices;
  std::vector<Role> Roles;
  std::vector<Index> Corners;
  std::vector<FeatureCurve> Curves;
  std::vector<Index> CurveOfEdge;
};

} // namespace evolving

#endif
