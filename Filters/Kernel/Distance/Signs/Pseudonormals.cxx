// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/Pseudonormals.h"

#include "Mesh/VertexNormals.h"

#include <algorithm>

namespace evolving
{

namespace
{

std::size_t indexOf(Index i)
{
  return static_cast<std::size_t>(i);
}

Vec3 unitNormal(const SurfaceMesh& mesh, Index face)
{
  const Vec3 area = faceVectorArea(mesh, face);
  const double length = area.norm();
  return length > 0.0 ? Vec3(area / length) : Vec3(Vec3::Zero());
}

} // namespace

Pseudonormals::Pseudonormals(const SurfaceMesh& mesh, const std::vector<Index>& edgeOfCorner)
  : Mesh(mesh)
  , EdgeOfCorner(edgeOfCorner)
  , OfFace(indexOf(mesh.faceCount()))
  , OfVertex(angleWeightedNormals(mesh))
{
  const auto lastEdge = std::max_element(edgeOfCorner.begin(), edgeOfCorner.end());
  this->OfEdge.assign(
    lastEdge == edgeOfCorner.end() ? 0 : indexOf(*lastEdge) + 1, Vec3(Vec3::Zero()));
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    this->OfFace[indexOf(face)] = unitNormal(mesh, face);
    for (Index corner = 3 * face; corner < 3 * face + 3; ++corner)
    {
      this->OfEdge[indexOf(edgeOfCorner[indexOf(corner)])] += this->OfFace[indexOf(face)];
    }
  }
}

const Vec3& Pseudonormals::at(Index face, TriangleFeature feature) const
{
  switch (feature)
  {
    case TriangleFeature::Edge0:
    case TriangleFeature::Edge1:
    case TriangleFeature::Edge2:
    {
      const int k = static_cast<int>(feature) - static_cast<int>(TriangleFeature::Edge0);
      return this->OfEdge[indexOf(this->EdgeOfCorner[indexOf(3 * face + k)])];
    }
    case TriangleFeature::Vertex0:
    case TriangleFeature::Vertex1:
    case TriangleFeature::Vertex2:
    {
      const int k = static_cast<int>(feature) - static_cast<int>(TriangleFeature::Vertex0);
      return this->OfVertex[indexOf(this->Mesh.faceVertex(face, k))];
    }
    case TriangleFeature::Face:
      break;
  }
  return this->OfFace[indexOf(face)];
}

bool Pseudonormals::isInside(const Vec3& point, Index face, const TrianglePoint& closest) const
{
  return (point - closest.point).dot(at(face, closest.feature)) < 0.0;
}

} // namespace evolving
