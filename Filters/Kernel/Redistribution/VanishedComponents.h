// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Parts of a surface that have shrunk to points while others go on.
 */

#ifndef EVOLVING_VANISHED_COMPONENTS_H
#define EVOLVING_VANISHED_COMPONENTS_H

#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/// A connected surface that has less than this part of its first area has shrunk to a point.
constexpr double SmallestAreaPart = 1e-8;

/**
 * Connected components below SmallestAreaPart. A surface of one component is not looked at:
 * when it vanishes, its evolution ends.
 */
class VanishedComponents
{
public:
  /**
   * @param topology must outlive this object
   * @param smallestArea that a component's first area counts as, if it is less: one that shrinks
   * from remeshing to remeshing, with an ever smaller start, must vanish one day
   */
  VanishedComponents(
    const SurfaceMesh& start, const MeshTopology& topology, double smallestArea = 0.0);

  /// Of the smallest component at the start; 0 where there is none.
  double smallestStartArea() const;

  void update(const SurfaceMesh& mesh);
  bool contain(Index vertex) const;

private:
  std::vector<double> areas(const SurfaceMesh& mesh) const;

  const MeshTopology& Topology;
  std::vector<double> StartArea;
  std::vector<char> IsVanished; ///< per component; empty when there is only one
};

} // namespace evolving

#endif
