// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/TargetTips.h"

#include "Mesh/Angles.h"

#include <limits>

namespace evolving
{

namespace
{

/// In radians; infinite where the triangles do not go around the vertex.
double angleAround(const TargetTriangles& target, Index vertex)
{
  double around = 0.0;
  for (const Index* f = target.facesBegin(vertex); f != target.facesEnd(vertex); ++f)
  {
    std::vector<Vec3> ways;
    for (Index k = 0; k < 3; ++k)
    {
      const Index edge = target.edgeOfFace(*f, k);
      const auto [a, b] = target.edgeVertices(edge);
      if (a == vertex || b == vertex)
      {
        ways.emplace_back(target.point(a == vertex ? b : a) - target.point(vertex));
        around +=
          target.edges().faceCount(edge) == 2 ? 0.0 : std::numeric_limits<double>::infinity();
      }
    }
    around += angleBetween(ways.front(), ways.back());
  }
  return around;
}

} // namespace

std::vector<Index> tipsOf(const TargetTriangles& target)
{
  std::vector<Index> tips;
  for (Index v = 0; v < target.mesh().vertexCount(); ++v)
  {
    const bool hasFaces = target.facesBegin(v) != target.facesEnd(v);
    if (hasFaces && angleAround(target, v) < Pi)
    {
      tips.push_back(v);
    }
  }
  return tips;
}

} // namespace evolving
