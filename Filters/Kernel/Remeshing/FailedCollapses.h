// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which tries to collapse edges need no repeating.
 */

#ifndef EVOLVING_FAILED_COLLAPSES_H
#define EVOLVING_FAILED_COLLAPSES_H

#include "Remeshing/EditableSurface.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * Edges that could not collapse: they still cannot, until a collapse changes one of their ends, its
 * point, what it is joined to or where that is. The other vertices of their two faces only lose
 * neighbours by collapses elsewhere, and so can only become a reason more to refuse.
 */
class FailedCollapses
{
public:
  explicit FailedCollapses(const EditableSurface& surface)
    : Surface(surface)
    , Tried(at(surface.edgeSlots()), Never)
    , Changed(at(surface.vertexSlots()), 0)
  {
  }

  bool contain(Index e) const
  {
    const Index tried = this->Tried[at(e)];
    const auto isAsThen = [&](Index v) { return this->Changed[at(v)] <= tried; };
    return isAsThen(this->Surface.from(e)) && isAsThen(this->Surface.to(e));
  }

  void add(Index e) { this->Tried[at(e)] = this->Collapses; }

  /// @param kept the vertex that an edge has become
  void addCollapse(Index kept)
  {
    ++this->Collapses;
    this->Changed[at(kept)] = this->Collapses;
    this->Surface.forEachNeighbour(
      kept, [this](Index u) { this->Changed[at(u)] = this->Collapses; });
  }

private:
  static constexpr Index Never = -1;

  const EditableSurface& Surface;
  Index Collapses = 0;
  ///@{
  /// After how many collapses.
  std::vector<Index> Tried;
  std::vector<Index> Changed;
  ///@}
};

} // namespace evolving

#endif
