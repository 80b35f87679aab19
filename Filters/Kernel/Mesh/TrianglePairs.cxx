// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TrianglePairs.h"

#include "Mesh/Orientation.h"
#include "Mesh/SegmentTriangle.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

TriangleCorners cornersOf(const std::vector<Vec3>& points, const TriangleVertices& vertices)
{
  const auto point = [&](std::size_t k) { return points[static_cast<std::size_t>(vertices[k])]; };
  return { point(0), point(1), point(2) };
}

/// Moves the shared vertices to the front of both, in the same order, and returns their number.
int alignShared(TriangleVertices& first, TriangleVertices& second)
{
  int shared = 0;
  for (Index& vertex : first)
  {
    const auto found = std::find(second.begin() + shared, second.end(), vertex);
    if (found != second.end())
    {
      std::swap(*found, second[static_cast<std::size_t>(shared)]);
      std::swap(vertex, first[static_cast<std::size_t>(shared)]);
      ++shared;
    }
  }
  return shared;
}

/// How far corners reach along a direction, seen from an origin, and the error of both numbers.
struct Extent
{
  double low = std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::lowest();
  double error = 0.0;
};

Extent extentAlong(
  const Vec3& direction, const Vec3& origin, const TriangleCorners& t, std::size_t firstCorner)
{
  constexpr double RelativeError = 1e-15; // four roundings of differences, products and sums
  Extent extent;
  double size = 0.0;
  for (std::size_t k = firstCorner; k < 3; ++k)
  {
    const Vec3 offset = t[k] - origin;
    const double position = direction.dot(offset);
    extent.low = std::min(extent.low, position);
    extent.high = std::max(extent.high, position);
    size = std::max(size, offset.lpNorm<Eigen::Infinity>());
  }
  extent.error = RelativeError * size * direction.lpNorm<1>();
  return extent;
}

Vec3 longestEdge(const TriangleCorners& t)
{
  Vec3 longest = t[0] - t[2];
  for (const Vec3& edge : { Vec3(t[1] - t[0]), Vec3(t[2] - t[1]) })
  {
    longest = edge.squaredNorm() > longest.squaredNorm() ? edge : longest;
  }
  return longest;
}

bool areClearlyApartAlong(const Vec3& direction, const TriangleCorners& t, const TriangleCorners& s)
{
  const Extent first = extentAlong(direction, t[0], t, 0);
  const Extent second = extentAlong(direction, t[0], s, 0);
  return second.low - second.error > first.high + first.error;
}

/// A quick look that is right when it says yes: a plane between the triangles keeps them apart.
/// Needles side by side, of which one begins where the other ends, have one along them.
bool areClearlyApart(const TriangleCorners& t, const TriangleCorners& s)
{
  const Vec3 direction = (s[0] + s[1] + s[2]) - (t[0] + t[1] + t[2]);
  if (areClearlyApartAlong(direction, t, s))
  {
    return true;
  }
  const Vec3 along = longestEdge(t);
  const Vec3 across = direction - along.dot(direction) / along.squaredNorm() * along;
  return areClearlyApartAlong(across, t, s);
}

/// The same with corner 0 shared: only there do the triangles touch the plane between them.
bool areClearlyApartButForCorner0(const TriangleCorners& t, const TriangleCorners& s)
{
  const Vec3& shared = t[0];
  const Vec3 direction =
    (s[1] + s[2] - 2.0 * shared).normalized() - (t[1] + t[2] - 2.0 * shared).normalized();
  const Extent first = extentAlong(direction, shared, t, 1);
  const Extent second = extentAlong(direction, shared, s, 1);
  return second.low > second.error && first.high < -first.error;
}

/// On which sides of a triangle's plane the corners of another one lie.
std::array<int, 3> sidesOf(const TriangleCorners& t, const TriangleCorners& other)
{
  return { orientation(t[0], t[1], t[2], other[0]), orientation(t[0], t[1], t[2], other[1]),
    orientation(t[0], t[1], t[2], other[2]) };
}

bool areOnOneSide(const std::array<int, 3>& sides)
{
  return sides[0] != 0 && sides[0] == sides[1] && sides[1] == sides[2];
}

bool anyEdgeMeets(
  const TriangleCorners& edges, const std::array<int, 3>& sides, const TriangleCorners& t)
{
  return segmentMeetsTriangle(edges[0], edges[1], sides[0], sides[1], t) ||
    segmentMeetsTriangle(edges[1], edges[2], sides[1], sides[2], t) ||
    segmentMeetsTriangle(edges[2], edges[0], sides[2], sides[0], t);
}

bool separateTrianglesMeet(const TriangleCorners& t, const TriangleCorners& s)
{
  if (areClearlyApart(t, s))
  {
    return false;
  }
  const std::array<int, 3> sSides = sidesOf(t, s);
  if (areOnOneSide(sSides))
  {
    return false;
  }
  const std::array<int, 3> tSides = sidesOf(s, t);
  return !areOnOneSide(tSides) && (anyEdgeMeets(s, sSides, t) || anyEdgeMeets(t, tSides, s));
}

/// Corner 0 is shared: the edges opposite to it decide.
bool trianglesAtCornerMeet(const TriangleCorners& t, const TriangleCorners& s)
{
  if (areClearlyApartButForCorner0(t, s))
  {
    return false;
  }
  const auto oppositeEdgeMeets = [](const TriangleCorners& edges, const TriangleCorners& other)
  {
    return segmentMeetsTriangle(edges[1], edges[2],
      orientation(other[0], other[1], other[2], edges[1]),
      orientation(other[0], other[1], other[2], edges[2]), other);
  };
  return oppositeEdgeMeets(t, s) || oppositeEdgeMeets(s, t);
}

/// Corners 0 and 1 are shared: in one plane and on the same side of the shared edge?
bool isFoldedFlat(const TriangleCorners& t, const TriangleCorners& s)
{
  bool sameSide = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int sides =
      planarOrientation(axis, t[0], t[1], t[2]) * planarOrientation(axis, s[0], s[1], s[2]);
    if (sides < 0)
    {
      return false;
    }
    sameSide = sameSide || sides > 0;
  }
  return sameSide && orientation(t[0], t[1], t[2], s[2]) == 0;
}

} // namespace

bool hasArea(const std::vector<Vec3>& points, const TriangleVertices& triangle)
{
  const TriangleCorners t = cornersOf(points, triangle);
  return planarOrientation(0, t[0], t[1], t[2]) != 0 ||
    planarOrientation(1, t[0], t[1], t[2]) != 0 || planarOrientation(2, t[0], t[1], t[2]) != 0;
}

bool intersectBeyondShared(
  const std::vector<Vec3>& points, TriangleVertices first, TriangleVertices second)
{
  const int shared = alignShared(first, second);
  const TriangleCorners t = cornersOf(points, first);
  const TriangleCorners s = cornersOf(points, second);
  switch (shared)
  {
    case 0:
      return separateTrianglesMeet(t, s);
    case 1:
      return trianglesAtCornerMeet(t, s);
    case 2:
      return isFoldedFlat(t, s);
    default:
      return true;
  }
}

} // namespace evolving
