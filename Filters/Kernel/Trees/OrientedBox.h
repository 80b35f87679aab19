// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A box turned so that it fits some triangles closely.
 */

#ifndef EVOLVING_ORIENTED_BOX_H
#define EVOLVING_ORIENTED_BOX_H

#include "Trees/TriangleGeometry.h"
#include "Types.h"

#include <vector>

namespace evolving
{

struct OrientedBox
{
  Vec3 center = Vec3::Zero();
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< unit columns
  Vec3 halfSize = Vec3::Zero();                       ///< along them
};

/**
 * A small group gets a box whose third axis is the mean normal and whose first is the direction in
 * that plane along which the corners spread most; a large one, which is no more flat than round,
 * an axis-aligned box.
 */
OrientedBox orientedBoxAround(const std::vector<const Triangle*>& triangles);

} // namespace evolving

#endif
