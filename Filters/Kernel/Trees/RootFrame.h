// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Coordinates whose floats are as fine as the model, wherever it lies.
 */

#ifndef EVOLVING_ROOT_FRAME_H
#define EVOLVING_ROOT_FRAME_H

#include "Types.h"

namespace evolving
{

/**
 * Counts from the middle of a tree's root box in half of its longest side, so that all of the root
 * is in [-1, 1]^3. A default one counts as everybody does.
 */
class RootFrame
{
public:
  RootFrame() = default;
  /// Of a box without a size only the middle matters; one beyond doubles is left as it is.
  explicit RootFrame(const Box& root);

  Vec3 local(const Vec3& point) const { return this->InverseHalfSize * (point - this->Middle); }
  Box local(const Box& box) const { return { this->local(box.min()), this->local(box.max()) }; }
  double localSquare(double square) const
  {
    return this->InverseHalfSize * this->InverseHalfSize * square;
  }
  /// The local length of one in the model's unit.
  double inverseHalfSize() const { return this->InverseHalfSize; }

  /// Back to the model; the corners are rounded to doubles there.
  Box global(const Box& box) const
  {
    return { Vec3(this->Middle + this->HalfSize * box.min()),
      Vec3(this->Middle + this->HalfSize * box.max()) };
  }

private:
  Vec3 Middle = Vec3::Zero();
  double HalfSize = 1.0;
  double InverseHalfSize = 1.0;
};

} // namespace evolving

#endif
