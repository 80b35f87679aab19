// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What can be said of a finished surface: its topology, its worst element, its distance to the
 * target. Measured, never assumed.
 */

#ifndef EVOLVING_SURFACE_REPORT_H
#define EVOLVING_SURFACE_REPORT_H

#include "Execution.h"
#include "FeatureCapture/FeatureCoverage.h"
#include "LostTopology/LostTopology.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "ShrinkWrap/CoarseParts.h"
#include "Types.h"

#include <functional>
#include <optional>
#include <vector>

namespace evolving
{

/// In edge lengths: what is farther apart on target and result does not stand for each other. Half
/// of it is what an element may lie beside its place, the rest what it may reach over.
constexpr double FarEdges = 2.0;

struct SurfaceReport
{
  bool isClosed = false;
  bool isManifold = false;     ///< one fan of faces at every vertex, consistently oriented
  Index selfIntersections = 0; ///< pairs of triangles
  Index genus = 0;             ///< of all components together; -1 when not closed or not manifold
  Index components = 0;
  double minAngle = 0.0;                 ///< degrees
  double maxDistance = 0.0;              ///< of a vertex from where it is meant to lie
  Vec3 intersectionPlace = Vec3::Zero(); ///< in one of the intersecting triangles
  Vec3 minAnglePlace = Vec3::Zero();     ///< the middle of that triangle
  Vec3 maxDistancePlace = Vec3::Zero();  ///< that vertex
  double lostPart = 0.0;                 ///< of the target's samples, see measureLoss(); 0 to 1
  Vec3 lostPlace = Vec3::Zero();         ///< the farthest of them
  FeatureCoverage creases;               ///< for who made the surface to say
  StageRuns adaptation;                  ///< likewise: of elements to the curvature
  CoarseParts coarse;                    ///< likewise
  double modelSize = 0.0;                ///< likewise: the diagonal of its box; 0 = unknown
  /// Likewise: what to ask for to get clearly smaller triangles; 0 where their size was asked for.
  Index morePoints = 0;
  std::optional<LostTopology> lost; ///< likewise: none where nothing was, or that is not known
};

/// How far a point is from where the surface is meant to lie.
using Deviation = std::function<double(const Vec3&)>;

/**
 * @param surface triangles
 * @throws Cancelled
 */
SurfaceReport examine(
  const SurfaceMesh& surface, const Deviation& deviation, const Execution& execution = {});

/**
 * Says how much of the target the surface has lost: parts thinner than its elements, or in gaps
 * that were closed.
 * @param samples of the part of the target that can be reached
 * @param far samples farther from the surface are lost
 * @throws Cancelled
 */
void measureLoss(const SurfaceMesh& surface, const std::vector<Vec3>& samples, double far,
  SurfaceReport& report, const Execution& execution = {});

} // namespace evolving

#endif
