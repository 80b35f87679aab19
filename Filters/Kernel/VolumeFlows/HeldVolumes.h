// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Volumes that a flow keeps.
 */

#ifndef EVOLVING_HELD_VOLUMES_H
#define EVOLVING_HELD_VOLUMES_H

#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * A Lagrange multiplier per connected component, so that each keeps the volume it had at the start.
 * Components do not know of each other: none grows at the cost of a smaller one.
 */
class HeldVolumes
{
public:
  /// @param topology of the start; must outlive this object
  HeldVolumes(const SurfaceMesh& start, const MeshTopology& topology);
  /**
   * Of elements that replace others, whose volumes they get. Where there are as many components as
   * before, each has the volume of the one that comes next to it in size; where some have parted or
   * vanished, what all have lost or won is shared out by volume.
   * @param before of the elements that were replaced
   */
  HeldVolumes(
    const SurfaceMesh& surface, const MeshTopology& topology, const std::vector<double>& before);

  /// One per component.
  const std::vector<double>& volumes() const { return this->Volumes; }

  /**
   * Moves every point by lambda times its direction, lambda of its component such that this has its
   * volume again: the root nearest to zero of a cubic polynomial, by Newton's method, to rounding.
   * @param directions one per vertex
   * @throws SolverError when no multiplier does it
   */
  void restore(SurfaceMesh& mesh, const std::vector<Vec3>& directions) const;

private:
  std::vector<double> multipliers(const SurfaceMesh& mesh, const std::vector<Vec3>& directions,
    double negligible, std::vector<double>& errors) const;

  const MeshTopology& Topology;
  std::vector<double> Volumes;
};

/**
 * Gives elements that replace others the volumes of those, along their normals; a boundary rests.
 * @param before as HeldVolumes; empty where nothing is held
 * @throws SolverError
 */
void giveBackVolumes(
  const std::vector<double>& before, SurfaceMesh& renewed, const Execution& execution);

} // namespace evolving

#endif
