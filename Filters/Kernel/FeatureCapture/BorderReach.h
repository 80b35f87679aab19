// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far the capture of creases moves vertices.
 */

#ifndef EVOLVING_BORDER_REACH_H
#define EVOLVING_BORDER_REACH_H

#include "Features/TargetFeatures.h"
#include "Remeshing/EditableSurface.h"
#include "Types.h"

namespace evolving
{

/**
 * The border of two labels that an edge crosses is no farther from it than it is long. At an acute
 * crease an edge that leads from side to side may be farther away, the more so the smaller the
 * angle is: there remeshing has worn off what is thinner than an element, and where sizes vary by
 * what is thinner than a large one.
 */
class BorderReach
{
public:
  BorderReach(const EditableSurface& surface, const TargetFeatures& features);

  /// How far a vertex of a size is moved onto an edge between labels of the target, a length.
  double ofEdge(Index targetEdge, double size) const;
  /// The same for a vertex of the target where labels meet: that of the most acute crease there.
  double ofCorner(Index targetVertex, double size) const;
  /// The point closest to a given one on the border between two labels; the given one itself where
  /// that is out of reach of a vertex of a size.
  Vec3 onBorder(const Vec3& point, Index a, Index b, double size) const;

private:
  const TargetFeatures& Features;
  double Largest = 0.0; ///< of all sizes
};

} // namespace evolving

#endif
