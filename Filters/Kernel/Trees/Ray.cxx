// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/Ray.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

/// The sign of an edge function; on the edge, that of the edge's direction, so that the two
/// triangles beside it disagree.
bool isPositive(double value, const Vec3& from, const Vec3& to)
{
  if (value != 0.0)
  {
    return value > 0.0;
  }
  return std::lexicographical_compare(from.data(), from.data() + 3, to.data(), to.data() + 3);
}

} // namespace

Ray::Ray(const Vec3& origin, const Vec3& direction)
  : Origin(origin)
  , Direction(direction)
{
  int longest = 0;
  direction.cwiseAbs().maxCoeff(&longest);
  this->Axes = { (longest + 1) % 3, (longest + 2) % 3, longest };
  this->Shear = Vec3(direction[this->Axes[0]], direction[this->Axes[1]], 1.0) / direction[longest];
}

std::optional<RayCrossing> Ray::crossing(const Triangle& triangle) const
{
  // Sheared so that the ray is the third axis: the crossing becomes a question about the
  // origin and a triangle in the plane.
  std::array<Vec3, 3> p;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 relative = triangle.corners[k] - this->Origin;
    const double depth = relative[this->Axes[2]];
    p[k] = Vec3(relative[this->Axes[0]] - this->Shear[0] * depth,
      relative[this->Axes[1]] - this->Shear[1] * depth, this->Shear[2] * depth);
  }
  std::array<double, 3> weight;
  std::array<bool, 3> positive;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::size_t from = (k + 1) % 3;
    const std::size_t to = (k + 2) % 3;
    weight[k] = p[from].x() * p[to].y() - p[from].y() * p[to].x();
    positive[k] = isPositive(weight[k], triangle.corners[from], triangle.corners[to]);
  }
  const double total = weight[0] + weight[1] + weight[2];
  if (positive[0] != positive[1] || positive[1] != positive[2] || total == 0.0)
  {
    return std::nullopt;
  }
  const double t = (weight[0] * p[0].z() + weight[1] * p[1].z() + weight[2] * p[2].z()) / total;
  if (!(t >= 0.0))
  {
    return std::nullopt;
  }
  // Counter-clockwise about the third axis: the normal points along it.
  return RayCrossing{ t, positive[0] == (this->Direction[this->Axes[2]] > 0.0) };
}

bool Ray::meets(const Box& box) const
{
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (this->Direction[axis] == 0.0)
    {
      if (this->Origin[axis] < box.min()[axis] || this->Origin[axis] > box.max()[axis])
      {
        return false;
      }
      continue;
    }
    double first = (box.min()[axis] - this->Origin[axis]) / this->Direction[axis];
    double second = (box.max()[axis] - this->Origin[axis]) / this->Direction[axis];
    if (first > second)
    {
      std::swap(first, second);
    }
    enter = std::max(enter, first);
    leave = std::min(leave, second);
  }
  return enter <= leave;
}

} // namespace evolving
