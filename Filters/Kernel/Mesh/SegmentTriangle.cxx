// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SegmentTriangle.h"

#include "Mesh/Orientation.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// Whether the closed segments pq and rs meet when a coordinate axis is dropped.
bool segmentsMeetInProjection(int axis, const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s)
{
  const int rSide = planarOrientation(axis, p, q, r);
  const int sSide = planarOrientation(axis, p, q, s);
  const int pSide = planarOrientation(axis, r, s, p);
  const int qSide = planarOrientation(axis, r, s, q);
  if (rSide * sSide > 0 || pSide * qSide > 0)
  {
    return false;
  }
  if (rSide != 0 || sSide != 0 || pSide != 0 || qSide != 0)
  {
    return true;
  }
  // All on one line: they meet when their extents do, in both remaining coordinates.
  const auto extentsMeet = [&](int i)
  {
    return std::max(std::min(p[i], q[i]), std::min(r[i], s[i])) <=
      std::min(std::max(p[i], q[i]), std::max(r[i], s[i]));
  };
  return extentsMeet((axis + 1) % 3) && extentsMeet((axis + 2) % 3);
}

bool isInsideInProjection(int axis, const Vec3& p, const TriangleCorners& t)
{
  const int sides[3] = { planarOrientation(axis, t[0], t[1], p),
    planarOrientation(axis, t[1], t[2], p), planarOrientation(axis, t[2], t[0], p) };
  return *std::min_element(sides, sides + 3) >= 0 || *std::max_element(sides, sides + 3) <= 0;
}

/**
 * Whether a segment in the plane of a triangle meets it: it does when it does in all three
 * projections, for at least one of them is one-to-one on the plane, and in the others the shadows
 * of sets that meet meet as well.
 */
bool coplanarSegmentMeets(const Vec3& p, const Vec3& q, const TriangleCorners& t)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!isInsideInProjection(axis, p, t) && !segmentsMeetInProjection(axis, p, q, t[0], t[1]) &&
      !segmentsMeetInProjection(axis, p, q, t[1], t[2]) &&
      !segmentsMeetInProjection(axis, p, q, t[2], t[0]))
    {
      return false;
    }
  }
  return true;
}

} // namespace

bool segmentMeetsTriangle(
  const Vec3& p, const Vec3& q, int pSide, int qSide, const TriangleCorners& t)
{
  if (pSide * qSide > 0)
  {
    return false;
  }
  if (pSide == 0 && qSide == 0)
  {
    return coplanarSegmentMeets(p, q, t);
  }
  // The line pq passes the triangle's edges all on the same side, or through one.
  const int turn = orientation(p, q, t[0], t[1]);
  const int nextTurn = orientation(p, q, t[1], t[2]);
  if (turn * nextTurn < 0)
  {
    return false;
  }
  const int lastTurn = orientation(p, q, t[2], t[0]);
  return turn * lastTurn >= 0 && nextTurn * lastTurn >= 0;
}

} // namespace evolving
