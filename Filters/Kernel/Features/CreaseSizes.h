// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How long the edges of elements may be beside creases.
 */

#ifndef EVOLVING_CREASE_SIZES_H
#define EVOLVING_CREASE_SIZES_H

#include "Execution.h"
#include "Features/SharpEdges.h"
#include "Features/TargetTriangles.h"
#include "Trees/AABBTree.h"
#include "Types.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace evolving
{

struct CreaseSizing
{
  double smallest = 0.0; ///< no shorter edges, in the target's unit
  double largest = 0.0;  ///< nor longer ones
  double step = 0.0;     ///< between samples of a crease; between two of them sizes hardly change
  double turn = 0.4;     ///< of a curved crease from edge to edge, in radians at most
  double across = 1.4;   ///< so many edges fit between two creases at least
  double growth = 0.3;   ///< of edges with the distance from a crease
};

/**
 * Beside a crease edges are so short that they follow its bends and that some fit between it and
 * the next crease of the same patch; away from it they grow.
 */
class CreaseSizes
{
public:
  /// @throws Cancelled
  CreaseSizes(const TargetTriangles& target, const SharpEdges& creases, const CreaseSizing& sizing,
    const Execution& execution = {});

  /// The same with other longest edges, shorter than these: measures nothing again.
  CreaseSizes withLargest(double largest) const;

  double smallest() const { return std::min(this->Smallest, this->Sizing.largest); }
  double growth() const { return this->Sizing.growth; }
  double largest() const { return this->Sizing.largest; }
  /// At a point on or beside the target, from the closest place of a crease alone: a mesh that has
  /// these sizes at its vertices still needs gradeSizes().
  double at(const Vec3& point) const;

private:
  CreaseSizing Sizing;
  double Smallest; ///< of all that are there
  std::shared_ptr<const std::vector<double>> Sizes;
  std::shared_ptr<const AABBTree> Samples; ///< points
};

} // namespace evolving

#endif
