// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where to begin a basis of the plane that a vector is normal to.
 */

#ifndef EVOLVING_ORTHOGONAL_H
#define EVOLVING_ORTHOGONAL_H

#include "Types.h"

namespace evolving
{

/// A vector orthogonal to v, by the coordinate axis that v is farthest from; at least 0.8 times as
/// long as v, zero for zero. With w = v x it, v, it and w are right-handed.
inline Vec3 orthogonalTo(const Vec3& v)
{
  Index axis = 0;
  v.cwiseAbs().minCoeff(&axis);
  return v.cross(Vec3(Vec3::Unit(axis)));
}

} // namespace evolving

#endif
