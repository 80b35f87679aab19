// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/OrientedBox.h"

#include <cmath>

namespace evolving
{

namespace
{

/// Of a normal or an edge: the square of a smaller one would be a number of few digits, and an axis
/// no unit vector.
constexpr double Shortest = 1e-150;

/// The mean normal whatever the faces' orientations; zero when none has an area.
Vec3 meanNormal(const std::vector<const Triangle*>& triangles)
{
  Vec3 sum = Vec3::Zero();
  for (const Triangle* triangle : triangles)
  {
    const Vec3 normal = triangle->doubleAreaNormal();
    sum += normal.dot(sum) < 0.0 ? Vec3(-normal) : normal;
  }
  const double length = sum.norm();
  return length > Shortest && std::isfinite(length) ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

/// The longest edge's direction: the axis of triangles without area.
Vec3 longestEdge(const std::vector<const Triangle*>& triangles)
{
  Vec3 longest = Vec3::Zero();
  for (const Triangle* triangle : triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Vec3 edge = triangle->corners[(k + 1) % 3] - triangle->corners[k];
      longest = edge.squaredNorm() > longest.squaredNorm() ? edge : longest;
    }
  }
  return longest;
}

/// Turns two axes in their plane so that the corners spread most along the first.
void turnToSpread(const std::vector<const Triangle*>& triangles, Eigen::Matrix3d& axes)
{
  const Vec3 from = triangles.front()->corners[0];
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double x = 0.0;
  double y = 0.0;
  for (const Triangle* triangle : triangles)
  {
    for (const Vec3& corner : triangle->corners)
    {
      const double a = (corner - from).dot(axes.col(0));
      const double b = (corner - from).dot(axes.col(1));
      x += a;
      y += b;
      xx += a * a;
      xy += a * b;
      yy += b * b;
    }
  }
  const double count = 3.0 * static_cast<double>(triangles.size());
  const double angle =
    0.5 * std::atan2(2.0 * (xy - x * y / count), (xx - x * x / count) - (yy - y * y / count));
  const Vec3 first = std::cos(angle) * axes.col(0) + std::sin(angle) * axes.col(1);
  axes.col(1) = std::cos(angle) * axes.col(1) - std::sin(angle) * axes.col(0);
  axes.col(0) = first;
}

Eigen::Matrix3d axesFor(const std::vector<const Triangle*>& triangles)
{
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  constexpr std::size_t LargestFlatGroup = 64;
  if (triangles.size() > LargestFlatGroup)
  {
    return axes;
  }
  const Vec3 normal = meanNormal(triangles);
  if (!normal.isZero(0.0))
  {
    axes.col(2) = normal;
    axes.col(0) = normal.unitOrthogonal();
    axes.col(1) = normal.cross(axes.col(0));
    turnToSpread(triangles, axes);
    return axes;
  }
  const Vec3 edge = longestEdge(triangles);
  const double length = edge.norm();
  if (length > Shortest)
  {
    axes.col(0) = edge / length;
    axes.col(1) = axes.col(0).unitOrthogonal();
    axes.col(2) = axes.col(0).cross(axes.col(1));
  }
  return axes;
}

} // namespace

OrientedBox orientedBoxAround(const std::vector<const Triangle*>& triangles)
{
  OrientedBox box;
  box.axes = axesFor(triangles);
  const Vec3 from = triangles.front()->corners[0];
  Box local;
  for (const Triangle* triangle : triangles)
  {
    for (const Vec3& corner : triangle->corners)
    {
      local.extend(Vec3(box.axes.transpose() * (corner - from)));
    }
  }
  box.center = from + box.axes * local.center();
  box.halfSize = 0.5 * local.sizes();
  return box;
}

} // namespace evolving
