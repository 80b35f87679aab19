// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/CutSlivers.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// The corner at which the longest edge begins.
std::size_t longestEdge(const Triangle& triangle, double& length)
{
  std::size_t longest = 0;
  length = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double other = (triangle.corners[(k + 1) % 3] - triangle.corners[k]).norm();
    longest = other > length ? k : longest;
    length = std::max(length, other);
  }
  return longest;
}

/// Is a triangle far longer than high? Not one without area, which no sum is made of.
bool isSliver(const Triangle& triangle, double longest)
{
  constexpr double Compact = 16.0; // eight such side by side, a leaf, are no longer than twice wide
  return !isDegenerate(triangle) &&
    longest * longest > Compact * triangle.doubleAreaNormal().norm();
}

/// How short pieces may be so that there are not too many.
double shortestPiece(const std::vector<Triangle>& triangles)
{
  double length = 0.0;
  for (const Triangle& triangle : triangles)
  {
    double longest = 0.0;
    longestEdge(triangle, longest);
    length += isSliver(triangle, longest) ? longest : 0.0;
  }
  // Some twenty pieces a triangle while all are sorted in about a second, else two.
  constexpr double Few = 600000.0;
  const auto count = static_cast<double>(triangles.size());
  const double pieces = std::max(2.0 * count, std::min(20.0 * count, Few));
  return 4.0 * length / pieces; // both long edges are halved, and once more than needed at most
}

/// Appends the pieces of a triangle.
void cut(const Triangle& whole, double shortest, std::vector<Triangle>& pieces)
{
  std::vector<Triangle> pending{ whole };
  while (!pending.empty())
  {
    const Triangle triangle = pending.back();
    pending.pop_back();
    double longest = 0.0;
    const std::size_t k = longestEdge(triangle, longest);
    if (!(longest > shortest) || !isSliver(triangle, longest))
    {
      pieces.push_back(triangle);
      continue;
    }
    const Vec3& from = triangle.corners[k];
    const Vec3& to = triangle.corners[(k + 1) % 3];
    const Vec3& opposite = triangle.corners[(k + 2) % 3];
    const Vec3 middle = 0.5 * (from + to);
    pending.push_back({ { from, middle, opposite } });
    pending.push_back({ { middle, to, opposite } });
  }
}

} // namespace

std::vector<Triangle> withSliversCut(const std::vector<Triangle>& triangles)
{
  const double shortest = shortestPiece(triangles);
  if (!(shortest > 0.0))
  {
    return triangles; // no slivers
  }
  std::vector<Triangle> pieces;
  pieces.reserve(triangles.size());
  for (const Triangle& triangle : triangles)
  {
    cut(triangle, shortest, pieces);
  }
  return pieces;
}

} // namespace evolving
