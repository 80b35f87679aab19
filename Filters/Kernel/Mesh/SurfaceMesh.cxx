// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SurfaceMesh.h"

#include "Errors.h"

#include <algorithm>

#include <sstream>

namespace evolving
{

namespace
{

void requireFinitePoint(const SurfaceMesh& mesh, Index vertex)
{
  if (!mesh.points[at(vertex)].allFinite())
  {
    std::ostringstream message;
    message << "Point " << vertex << " has the coordinates (" << mesh.points[at(vertex)].transpose()
            << "), expected finite numbers; remove or repair it before this filter.";
    throw InputError(message.str());
  }
}

void requireValidFace(const SurfaceMesh& mesh, Index face)
{
  if (mesh.faceSize(face) < 3)
  {
    std::ostringstream message;
    message << "Face " << face << " has " << mesh.faceSize(face)
            << " corners, expected at least 3; remove it before this filter.";
    throw InputError(message.str());
  }
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    const Index vertex = mesh.faceVertex(face, k);
    if (vertex < 0 || vertex >= mesh.vertexCount())
    {
      std::ostringstream message;
      message << "Face " << face << " refers to point " << vertex << ", but there are only "
              << mesh.vertexCount() << " points; the file is damaged, export it again.";
      throw InputError(message.str());
    }
    requireFinitePoint(mesh, vertex);
  }
}

} // namespace

Index SurfaceMesh::addPoint(const Vec3& point)
{
  this->points.push_back(point);
  return this->vertexCount() - 1;
}

Index SurfaceMesh::addFace(std::initializer_list<Index> vertices)
{
  return this->addFace(vertices.begin(), vertices.end());
}

Index SurfaceMesh::addFace(const std::vector<Index>& vertices)
{
  return this->addFace(vertices.data(), vertices.data() + vertices.size());
}

Index SurfaceMesh::addFace(const Index* begin, const Index* end)
{
  this->cornerVertices.insert(this->cornerVertices.end(), begin, end);
  this->faceOffsets.push_back(this->cornerCount());
  return this->faceCount() - 1;
}

bool operator==(const SurfaceMesh& a, const SurfaceMesh& b)
{
  return a.points == b.points && haveEqualFaces(a, b);
}

bool haveEqualFaces(const SurfaceMesh& a, const SurfaceMesh& b)
{
  return a.faceOffsets == b.faceOffsets && a.cornerVertices == b.cornerVertices;
}

bool SurfaceMesh::hasOnlyTriangles() const
{
  for (Index face = 0; face < this->faceCount(); ++face)
  {
    if (this->faceSize(face) != 3)
    {
      return false;
    }
  }
  return true;
}

Box boundingBox(const SurfaceMesh& mesh)
{
  Box box;
  for (const Index vertex : mesh.cornerVertices)
  {
    box.extend(mesh.points[at(vertex)]);
  }
  if (mesh.cornerVertices.empty())
  {
    for (const Vec3& point : mesh.points)
    {
      box.extend(point);
    }
  }
  return box;
}

Vec3 faceVectorArea(const SurfaceMesh& mesh, Index face)
{
  return faceVectorArea(mesh, mesh.points, face);
}

Vec3 faceVectorArea(const SurfaceMesh& mesh, const std::vector<Vec3>& points, Index face)
{
  // A fan about the first corner: exact for every planar polygon, convex or not.
  const Index* const corners = mesh.cornerVertices.data() + mesh.faceOffsets[at(face)];
  const Vec3& base = points[at(corners[0])];
  Vec3 twice = Vec3::Zero();
  for (Index k = 1; k + 1 < mesh.faceSize(face); ++k)
  {
    twice += (points[at(corners[k])] - base).cross(points[at(corners[k + 1])] - base);
  }
  return 0.5 * twice;
}

double surfaceArea(const SurfaceMesh& mesh)
{
  double area = 0.0;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    area += faceVectorArea(mesh, face).norm();
  }
  return area;
}

double signedVolume(const SurfaceMesh& mesh)
{
  const Box box = boundingBox(mesh);
  if (box.isEmpty())
  {
    return 0.0;
  }
  return signedVolume(mesh, box.center());
}

/// By vector areas, of edges: the cross products of far corners would lose the volume of small parts.
double signedVolume(const SurfaceMesh& mesh, const Vec3& center)
{
  double threefold = 0.0;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    threefold += faceVectorArea(mesh, face).dot(mesh.facePoint(face, 0) - center);
  }
  return threefold / 3.0;
}

void validate(const SurfaceMesh& mesh)
{
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    requireValidFace(mesh, face);
  }
  if (mesh.faceCount() == 0)
  {
    for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
    {
      requireFinitePoint(mesh, vertex);
    }
  }
}

SurfaceMesh reversed(const SurfaceMesh& mesh)
{
  SurfaceMesh other = mesh;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const auto f = static_cast<std::size_t>(face);
    std::reverse(other.cornerVertices.begin() + mesh.faceOffsets[f],
      other.cornerVertices.begin() + mesh.faceOffsets[f + 1]);
  }
  return other;
}

} // namespace evolving
