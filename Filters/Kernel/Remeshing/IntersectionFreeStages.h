// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Work on a surface that must not make it run through itself.
 */

#ifndef EVOLVING_INTERSECTION_FREE_STAGES_H
#define EVOLVING_INTERSECTION_FREE_STAGES_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

#include <functional>
#include <vector>

namespace evolving
{

/// Changes a surface in any way that leaves locked faces alone (EditableSurface::setLocked()).
using RemeshingStage = std::function<void(EditableSurface& surface)>;

/// What has become of a stage.
struct StageRuns
{
  Index intersections = 0;   ///< pairs of triangles that the first run made intersect
  bool isLeftOut = false;    ///< no run was good, or the one that was had all locked
  Vec3 place = Vec3::Zero(); ///< a corner of a triangle that the last run spoiled, then
};

/**
 * Runs a stage on a surface without self-intersections. Where the stage makes some, it is
 * smoothed, untangle(). Where that does not help, the surface goes back to what it was, is locked
 * within a few sizes around, and the stage runs again; at last the stage is left out altogether,
 * or as soon as what is locked makes as many small angles beside it as there were without locks.
 * So the surface has no self-intersections afterwards, and is compact.
 * Locks of the stage are released at the end.
 * @param leastAngle where the stage leaves more than two triangles with smaller angles, in
 *   degrees, the surface goes back too
 * @throws Cancelled
 */
StageRuns runWithoutIntersections(EditableSurface& surface, const RemeshingStage& stage,
  const Execution& execution = {}, double leastAngle = 0.0);

/**
 * The same for a stage that only moves vertices, and faster: the vertices of triangles that
 * intersect go back, undoIntersections(), and the stage does not run again.
 * @return the number of vertices that went back
 * @throws Cancelled
 */
Index moveWithoutIntersections(
  EditableSurface& surface, const RemeshingStage& stage, const Execution& execution = {});

/**
 * Takes vertices of intersecting triangles, and if need be more and more around them, back to
 * where they were.
 * @param before one point per vertex, without intersections
 * @return the number of vertices taken back
 * @throws Cancelled
 */
Index undoIntersections(
  SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution = {});

} // namespace evolving

#endif
