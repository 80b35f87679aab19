// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far points of a target are from a surface that moves.
 */

#ifndef EVOLVING_SAMPLE_DISTANCES_H
#define EVOLVING_SAMPLE_DISTANCES_H

#include "Execution.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * The closest face of each sample. When the surface's vertices have moved, but no farther than to
 * their neighbours, update() measures anew without a search.
 */
class SampleDistances
{
public:
  /**
   * @param nearest samples nearer than this part of the surface's size are left out
   * @throws Cancelled
   */
  SampleDistances(const EditableSurface& surface, const std::vector<Vec3>& samples, double nearest,
    const Execution& execution);

  /// The surface must have the same faces.
  void update();

  std::size_t count() const { return this->Samples.size(); }
  const Vec3& sample(std::size_t s) const { return this->Samples[s]; }
  Index face(std::size_t s) const { return this->Faces[s]; }
  double distance(std::size_t s) const { return this->Distances[s]; }
  /// The samples for which a face is the closest.
  const std::vector<std::size_t>& samplesAt(Index face) const
  {
    return this->SamplesOfFace[static_cast<std::size_t>(face)];
  }

  /// The faces that share a vertex with a face, in ascending order.
  std::vector<Index> facesAround(Index face) const;

private:
  void sortByFace();

  const EditableSurface& Surface;
  std::vector<Vec3> Samples;
  std::vector<Index> Faces;
  std::vector<double> Distances;
  std::vector<std::vector<std::size_t>> SamplesOfFace;
};

} // namespace evolving

#endif
