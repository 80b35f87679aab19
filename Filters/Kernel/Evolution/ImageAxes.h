// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How an image lies in space: medical images are seldom along the axes of the world.
 */

#ifndef EVOLVING_IMAGE_AXES_H
#define EVOLVING_IMAGE_AXES_H

#include "Types.h"

namespace evolving
{

/**
 * Turns points and vectors between the world and the image's own axes, about the image's origin.
 * Lengths stay, so distances and slopes are the same in both. By default both are the same, and
 * nothing is computed.
 */
class ImageAxes
{
public:
  ImageAxes() = default;
  /**
   * @param directions unit vectors along the image's axes, as columns: a rotation, or one with a
   * reflection (left-handed images). Rounded ones, as in files, are made exactly orthogonal.
   * @param origin that stays where it is
   * @throws InputError when they are not orthogonal or not of length one to 1e-4, or not finite
   */
  ImageAxes(const Eigen::Matrix3d& directions, const Vec3& origin);

  bool areTheWorlds() const { return this->AreTheWorlds; }
  Vec3 pointFromWorld(const Vec3& point) const;
  Vec3 pointToWorld(const Vec3& point) const;
  Vec3 vectorToWorld(const Vec3& vector) const;
  /// The smallest box along the axes of the world around one along the image's axes.
  Box boxInWorld(const Box& box) const;

private:
  bool AreTheWorlds = true;
  Eigen::Matrix3d Directions = Eigen::Matrix3d::Identity();
  Vec3 Origin = Vec3::Zero();
};

} // namespace evolving

#endif
