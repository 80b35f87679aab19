// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PolygonEars.h"

#include "Mesh/Orientation.h"

#include <algorithm>
#include <cmath>

namespace robustness
{

namespace
{

const Vec3& at(const std::vector<Vec3>& points, std::int64_t id)
{
  return points[static_cast<std::size_t>(id)];
}

/// Newell's normal, not of unit length.
Vec3 normalOf(const std::vector<Vec3>& points, const Cell& polygon)
{
  Vec3 normal = Vec3::Zero();
  const Vec3& origin = at(points, polygon.front());
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
  {
    normal += (at(points, polygon[k]) - origin).cross(at(points, polygon[k + 1]) - origin);
  }
  return normal;
}

/// The polygon seen along an axis, so that it runs counter-clockwise.
struct View
{
  const std::vector<Vec3>& points;
  int axis = 0;
  int sign = 1;

  int turn(std::int64_t a, std::int64_t b, std::int64_t c) const
  {
    return this->sign *
      evolving::planarOrientation(
        this->axis, at(this->points, a), at(this->points, b), at(this->points, c));
  }
};

View viewOf(const std::vector<Vec3>& points, const Cell& polygon)
{
  const Vec3 normal = normalOf(points, polygon);
  View view{ points };
  normal.cwiseAbs().maxCoeff(&view.axis);
  view.sign = normal[view.axis] < 0.0 ? -1 : 1;
  return view;
}

bool isEar(const View& view, const Cell& polygon, std::size_t k)
{
  const std::size_t n = polygon.size();
  const std::int64_t a = polygon[(k + n - 1) % n];
  const std::int64_t b = polygon[k];
  const std::int64_t c = polygon[(k + 1) % n];
  if (view.turn(a, b, c) <= 0)
  {
    return false;
  }
  return std::none_of(polygon.begin(), polygon.end(),
    [&](std::int64_t p)
    {
      return p != a && p != b && p != c && view.turn(a, b, p) >= 0 && view.turn(b, c, p) >= 0 &&
        view.turn(c, a, p) >= 0;
    });
}

bool segmentsMeet(const View& view, std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t d)
{
  return view.turn(a, b, c) * view.turn(a, b, d) <= 0 &&
    view.turn(c, d, a) * view.turn(c, d, b) <= 0;
}

bool isSimple(const std::vector<Vec3>& points, const Cell& polygon)
{
  const View view = viewOf(points, polygon);
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    if (view.turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) == 0)
    {
      return false;
    }
    for (std::size_t j = i + 2; j < n; ++j)
    {
      const bool areNeighbours = (j + 1) % n == i;
      if (!areNeighbours &&
        segmentsMeet(view, polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n]))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

std::vector<Triangle> earsOf(const std::vector<Vec3>& points, const Cell& polygon)
{
  if (polygon.size() == 3)
  {
    return { { polygon[0], polygon[1], polygon[2] } };
  }
  std::vector<Triangle> ears;
  const View view = viewOf(points, polygon);
  Cell rest = polygon;
  for (std::size_t k = 0; k < rest.size() && rest.size() > 3;)
  {
    if (!isEar(view, rest, k))
    {
      ++k;
      continue;
    }
    const std::size_t n = rest.size();
    ears.push_back({ rest[(k + n - 1) % n], rest[k], rest[(k + 1) % n] });
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
    k = 0;
  }
  if (rest.size() == 3)
  {
    ears.push_back({ rest[0], rest[1], rest[2] });
  }
  return ears;
}

bool isPlanarAndSimple(const std::vector<Vec3>& points, const Cell& polygon)
{
  if (polygon.size() == 3)
  {
    return true;
  }
  constexpr double Flat = 1e-9;
  const Vec3 normal = normalOf(points, polygon).normalized();
  double size = 0.0;
  double height = 0.0;
  for (const std::int64_t id : polygon)
  {
    const Vec3 offset = at(points, id) - at(points, polygon.front());
    size = std::max(size, offset.norm());
    height = std::max(height, std::abs(normal.dot(offset)));
  }
  return height <= Flat * size && isSimple(points, polygon);
}

} // namespace robustness
