// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A step that turns no face over.
 */

#ifndef EVOLVING_INVERSION_LIMITER_H
#define EVOLVING_INVERSION_LIMITER_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Redistribution/VanishedComponents.h"

#include <functional>
#include <vector>

namespace evolving
{

/// A step that would turn over more than this part of the faces has failed.
constexpr double LargestTurnedPart = 0.2;

/// Where the vertices of a step go.
struct LimitedMove
{
  std::vector<Vec3> displacement; ///< changed by the limiter
  std::vector<double> fraction;   ///< of it, in [0, 1]; chosen by the limiter
};

/// Moves the mesh by fraction times displacement, from where it was before the step.
using PlaceVertices = std::function<void()>;

/**
 * Changes the moves of single vertices until no face turns by more than a right angle. Where a
 * surface pinches off, or a sliver lies across the flow, the flow itself turns faces over, and
 * shorter steps would not help. So first the vertices of faces that would turn also move along the
 * surface, to where the elements around them are well shaped. Where that does not help they take
 * the mean of their moves, for a face that is carried along as it is does not turn; at last they
 * wait while all others go on.
 *
 * Faces that have no area at the start or lie the wrong way round, against the normals of their
 * vertices, may turn: they must unfold. Those of vanished components have no sides.
 */
class InversionLimiter
{
public:
  /// @param normals of the start's vertices
  /// @param vanished must outlive this object, and be up to date
  InversionLimiter(const SurfaceMesh& start, const MeshTopology& topology,
    const std::vector<Vec3>& normals, const VanishedComponents& vanished);

  /**
   * @param mesh at the points after the step
   * @param before the points before it, or before an earlier step if all since were limited
   * @param normals of the vertices before the step
   * @param move displacement: of the step
   * @param place moves the mesh
   * @throws SolverError when more faces than LargestTurnedPart turn over
   */
  void limit(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
    const std::vector<Vec3>& normals, LimitedMove& move, const PlaceVertices& place,
    const Execution& execution) const;

  /// Has a move turned faces over that may not?
  bool hasTurned(
    const SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution) const
  {
    return !this->turnedFaces(mesh, before, execution).empty();
  }

private:
  bool isTurned(const SurfaceMesh& mesh, const std::vector<Vec3>& before, Index face) const;
  std::vector<Index> turnedFaces(
    const SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution) const;

  const MeshTopology& Topology;
  const VanishedComponents& Vanished;
  std::vector<char> MayTurn; ///< per face
};

} // namespace evolving

#endif
