// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/PolylineTree.h"

#include <utility>

namespace evolving
{

namespace
{

SurfaceMesh edgesAsTriangles(const TargetTriangles& target, const std::vector<Index>& edges)
{
  SurfaceMesh mesh;
  for (const Index edge : edges)
  {
    const auto [a, b] = target.edgeVertices(edge);
    const Index first = mesh.addPoint(target.point(a));
    const Index second = mesh.addPoint(target.point(b));
    mesh.addFace({ first, second, second });
  }
  return mesh;
}

} // namespace

PolylineTree::PolylineTree(const TargetTriangles& target, std::vector<Index> edges)
  : Edges(std::move(edges))
  , Tree(edgesAsTriangles(target, this->Edges))
{
}

EdgePoint PolylineTree::closest(const Vec3& point) const
{
  const ClosestTriangle found = this->Tree.closest(point);
  if (found.triangle == NoIndex)
  {
    return {};
  }
  const Index edge = this->Edges[static_cast<std::size_t>(found.triangle)];
  return { edge, found.at.point, found.at.squaredDistance };
}

} // namespace evolving
