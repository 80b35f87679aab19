// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoint/FramedTriangle.h"

namespace evolving
{

namespace
{

void store(const Vec3& vector, float stored[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    stored[axis] = static_cast<float>(vector[axis]);
  }
}

/// The corner at which the longest edge begins.
std::size_t longestEdge(const Triangle& triangle)
{
  std::size_t longest = 0;
  double squaredLength = -1.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double squared = (triangle.corners[(k + 1) % 3] - triangle.corners[k]).squaredNorm();
    longest = squared > squaredLength ? k : longest;
    squaredLength = std::max(squaredLength, squared);
  }
  return longest;
}

FramedTriangle::Edge edgeBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  FramedTriangle::Edge edge;
  const double length = (to - from).norm();
  // An edge of no length runs against the first, so that nothing is on the left of both.
  const Eigen::Vector2d direction = length > FramedTriangle::ShortestEdge
    ? Eigen::Vector2d((to - from) / length)
    : Eigen::Vector2d(-1.0, 0.0);
  edge.directionX = static_cast<float>(direction.x());
  edge.directionY = static_cast<float>(direction.y());
  edge.length = static_cast<float>(length);
  edge.beginAlong = static_cast<float>(from.dot(direction));
  edge.beginBeside = static_cast<float>(from.y() * direction.x() - from.x() * direction.y());
  return edge;
}

} // namespace

FramedTriangle::FramedTriangle(const Triangle& triangle, Index triangleNumber)
  : number(triangleNumber)
{
  const std::size_t first = longestEdge(triangle);
  const Vec3& origin = triangle.corners[first];
  const Vec3 edge = triangle.corners[(first + 1) % 3] - origin;
  const Vec3 toOpposite = triangle.corners[(first + 2) % 3] - origin;
  const double longest = edge.norm();
  const Vec3 x = longest > ShortestEdge ? Vec3(edge / longest) : Vec3(Vec3::UnitX());
  const Vec3 rise = toOpposite - toOpposite.dot(x) * x;
  const bool isFlat = isDegenerate(triangle) || !(rise.norm() > ShortestEdge);
  const Vec3 y = isFlat ? Vec3(x.unitOrthogonal()) : Vec3(rise.normalized());
  const double top = isFlat ? 0.0 : rise.norm();
  const Eigen::Vector2d end(longest, 0.0);
  const Eigen::Vector2d opposite(toOpposite.dot(x), top);
  for (int axis = 0; axis < 3; ++axis)
  {
    this->anchor[axis] = origin[axis];
  }
  store(x, this->along);
  store(y, this->beside);
  store(x.cross(y), this->normal);
  this->length = static_cast<float>(longest);
  this->height = static_cast<float>(top);
  this->second = edgeBetween(end, opposite);
  this->third = edgeBetween(opposite, Eigen::Vector2d::Zero());
}

} // namespace evolving
