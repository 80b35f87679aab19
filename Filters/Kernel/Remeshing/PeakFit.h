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
#include "Remeshing/SampleDistances.h"

#include <limits>
#include <vector>

namespace evolving
{

struct PeakFitOptions
{
  double tolerance = 0.2; ///< of the size: samples nearer than this are left alone
  /// Samples beyond are none of the surface's business; inside they may be hidden parts.
  double farthest = std::numeric_limits<double>::infinity();
  double deepest = std::numeric_limits<double>::infinity();
  double leastAngle = 44.5; ///< degrees: no angle falls below it, nor below the smallest around
  int rounds = 3;
};

/**
 * Lowers the largest distance from points of the target to the surface. A least-squares fit gives
 * up a peak for the sake of the many places around; here the face nearest to such a point comes
 * towards it, as far as that lowers the larger of the two distances, from points of the target to
 * the faces around and from these faces to the target.
 */
class PeakFit
{
public:
  /**
   * @param surface keeps its faces from now on
   * @param samples points of the target
   * @param nearest samples nearer than this part of the size are no peaks now and will be none
   * @throws Cancelled
   */
  PeakFit(EditableSurface& surface, const ReferenceSurface& reference,
    const std::vector<Vec3>& samples, double nearest = 0.0, const Execution& execution = {});

  /// @return the number of faces moved
  Index run(const PeakFitOptions& options);

private:
  Index runOnce(const PeakFitOptions& options);
  std::vector<std::size_t> peaks(const PeakFitOptions& options) const;
  bool isPeak(std::size_t s, const PeakFitOptions& options) const;
  bool approach(std::size_t s, const std::vector<Index>& faces, double leastAngle);
  double largestDistance(const std::vector<Index>& faces, double bound) const;
  double squaredDistanceToReference(Index f) const;

  EditableSurface& Surface;
  const ReferenceSurface& Reference;
  Execution Run;
  SampleDistances Distances;
  /// Of each sample: of the faces around it when it was last tried, which would be in vain again.
  std::vector<std::size_t> InVain;
};

/// The same for one run.
inline Index fitPeaks(EditableSurface& surface, const ReferenceSurface& reference,
  const std::vector<Vec3>& samples, const PeakFitOptions& options, const Execution& execution = {})
{
  return PeakFit(surface, reference, samples, 0.0, execution).run(options);
}

} // namespace evolving

#endif
