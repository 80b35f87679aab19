// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ImageAxes.h"

#include "Errors.h"

#include <Eigen/LU>

#include <sstream>

namespace evolving
{

namespace
{

/// Files write direction cosines with five or six digits. Over a thousand samples an error of this
/// size is a tenth of a cell.
constexpr double FileDigits = 1e-4;
/// What a product of rotations that should give the identity is off by; far below any cell.
constexpr double RoundingError = 1e-12;

bool areOrthonormal(const Eigen::Matrix3d& directions)
{
  const Eigen::Matrix3d error = directions.transpose() * directions - Eigen::Matrix3d::Identity();
  return directions.allFinite() && error.cwiseAbs().maxCoeff() <= FileDigits;
}

/// The closest orthogonal matrix: Newton's iteration for the polar decomposition squares the error
/// each time, from 1e-4 to rounding in two steps.
Eigen::Matrix3d closestOrthogonal(Eigen::Matrix3d directions)
{
  for (int step = 0; step < 3; ++step)
  {
    const Eigen::Matrix3d inverse = directions.inverse();
    directions = 0.5 * (directions + inverse.transpose());
  }
  return directions;
}

} // namespace

ImageAxes::ImageAxes(const Eigen::Matrix3d& directions, const Vec3& origin)
  : Origin(origin)
{
  if (!areOrthonormal(directions))
  {
    std::ostringstream message;
    message << "The image has the direction matrix (" << directions.row(0) << "; "
            << directions.row(1) << "; " << directions.row(2)
            << "), expected a rotation or reflection: columns of length one at right angles; "
               "resample the image.";
    throw InputError(message.str());
  }
  this->AreTheWorlds =
    (directions - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= RoundingError;
  this->Directions = closestOrthogonal(directions);
}

Vec3 ImageAxes::pointFromWorld(const Vec3& point) const
{
  return this->AreTheWorlds
    ? point
    : Vec3(this->Origin + this->Directions.transpose() * (point - this->Origin));
}

Vec3 ImageAxes::pointToWorld(const Vec3& point) const
{
  return this->AreTheWorlds ? point
                            : Vec3(this->Origin + this->Directions * (point - this->Origin));
}

Vec3 ImageAxes::vectorToWorld(const Vec3& vector) const
{
  return this->AreTheWorlds ? vector : Vec3(this->Directions * vector);
}

Box ImageAxes::boxInWorld(const Box& box) const
{
  if (this->AreTheWorlds || box.isEmpty())
  {
    return box;
  }
  Box around;
  for (int corner = 0; corner < 8; ++corner)
  {
    around.extend(this->pointToWorld(box.corner(static_cast<Box::CornerType>(corner))));
  }
  return around;
}

} // namespace evolving
