// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The middles of what is in front of a closed surface, and of what is behind it.
 */

#ifndef EVOLVING_MEDIAL_PROBES_H
#define EVOLVING_MEDIAL_PROBES_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// From a place of a triangle straight to the next triangle.
struct MedialProbe
{
  Index triangle = NoIndex; ///< where it begins
  Index across = NoIndex;   ///< where it ends
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();

  Vec3 middle() const { return 0.5 * (this->from + this->to); }
  double width() const { return (this->to - this->from).norm(); }
};

/// Where probes begin: at least one place on every triangle with an area.
struct ProbePlaces
{
  std::vector<Index> triangles;
  std::vector<Vec3> points;
  /// Of each triangle: about how far places are from the next ones on it.
  std::vector<double> reach;
};

/// @param spacing of the places on triangles that are large enough
ProbePlaces probePlaces(const SurfaceMesh& surface, double spacing);

enum class ProbeSide
{
  Front,
  Behind,
};

/**
 * Along the normals of a closed surface, in front of it through the open, behind it through the
 * solid. Places that see nothing there have none.
 * @throws Cancelled
 */
std::vector<MedialProbe> medialProbes(const AABBTree& surface, const ProbePlaces& places,
  ProbeSide side, const Execution& execution = {});

/// Is the middle about as far from all of the surface as from the ends? Along a slit, or from rim
/// to rim through a plate, it is not.
bool isWidth(const AABBTree& surface, const MedialProbe& probe);

} // namespace evolving

#endif
