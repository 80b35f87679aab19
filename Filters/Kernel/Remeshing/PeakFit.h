// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Peaks and ridges of a target that the triangles cut off.
 */

#ifndef EVOLVING_PEAK_FIT_H
#define EVOLVING_PEAK_FIT_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/ReferenceSurface.h"

#include <vector>

namespace evolving
{

struct PeakFitOptions
{
  double tolerance = 0.2;   ///< of the size: samples nearer than this are left alone
  double farthest = 1.5;    ///< of the size: samples beyond are none of the surface's business
  double deepest = 0.35;    ///< the same for samples inside, which may be hidden parts
  double leastAngle = 44.5; ///< degrees: no angle falls below it, nor below the smallest around
  int rounds = 3;
};

/// The samples farther from the surface than a fraction of its size: all that fitPeaks() needs.
std::vector<Vec3> samplesBeyond(const EditableSurface& surface, const std::vector<Vec3>& samples,
  double tolerance, const Execution& execution = {});

/**
 * Lowers the largest distance from points of the target to the surface. A least-squares fit gives
 * up a peak for the sake of the many places around; here the face nearest to such a point comes
 * towards it, as far as that lowers the larger of the two distances, from points of the target to
 * the faces around and from these faces to the target.
 * @param samples points of the target
 * @return the number of faces moved
 */
Index fitPeaks(EditableSurface& surface, const ReferenceSurface& reference,
  const std::vector<Vec3>& samples, const PeakFitOptions& options, const Execution& execution = {});

} // namespace evolving

#endif
