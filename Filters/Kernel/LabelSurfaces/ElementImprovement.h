// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Better elements where sheets meet.
 */

#ifndef EVOLVING_ELEMENT_IMPROVEMENT_H
#define EVOLVING_ELEMENT_IMPROVEMENT_H

#include "Execution.h"
#include "LabelSurfaces/EditableInterfaces.h"
#include "LabelSurfaces/InterfaceElements.h"
#include "Types.h"

#include <functional>
#include <vector>

namespace evolving
{

/**
 * A curve where sheets meet has a vertex for each corner of voxels along its stairs, more than its
 * length has room for, and some of them beyond their neighbours. Here vertices of sheets slide in
 * their tangent planes, and those of curves along these, to where the smallest angle around them is
 * largest; edges are flipped and collapsed where that makes the smallest angle larger. What is
 * turned over gets unfolded (InterfaceElements).
 */
class ElementImprovement
{
public:
  /// May a vertex of the net be at a place?
  using Limit = std::function<bool(Index vertex, const Vec3& place)>;

  /// @param mesh where voxels have the volume 1
  ElementImprovement(EditableInterfaces& mesh, Limit limit);

  /// @throws Cancelled
  void run(const Execution& execution);

private:
  void slide(Index vertex);
  std::vector<Vec3> directions(Index vertex) const;
  void treat(Index triangle);
  bool collapseOne(Index triangle);
  double gainOfCollapse(Index from, Index to) const;
  bool isFlat(Index from, Index to) const;
  bool flipLongest(Index triangle);

  EditableInterfaces& Mesh;
  Limit IsAllowed;
  InterfaceElements Elements;
};

} // namespace evolving

#endif
