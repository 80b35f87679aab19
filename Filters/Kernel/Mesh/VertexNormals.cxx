// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/VertexNormals.h"

#include <cmath>

namespace evolving
{

namespace
{

constexpr double FullTurn = 6.283185307179586;

Vec3 normalizedOrZero(const Vec3& vector)
{
  const double length = vector.norm();
  return length > 0.0 ? Vec3(vector / length) : Vec3(Vec3::Zero());
}

/// The unit normal of a face; zero for a face without area.
Vec3 faceNormal(const SurfaceMesh& mesh, Index face)
{
  return normalizedOrZero(faceVectorArea(mesh, face));
}

/// The interior angle of a face at its corner k, more than pi where a polygon is concave.
double interiorAngle(const SurfaceMesh& mesh, Index face, Index k, const Vec3& normal)
{
  const Index size = mesh.faceSize(face);
  const Vec3& corner = mesh.facePoint(face, k);
  const Vec3 next = mesh.facePoint(face, (k + 1) % size) - corner;
  const Vec3 previous = mesh.facePoint(face, (k + size - 1) % size) - corner;
  const double sine = normal.dot(next.cross(previous));
  const double cosine = next.dot(previous);
  if (size == 3) // never concave: a negative sine would be rounding in a needle
  {
    return std::atan2(std::abs(sine), cosine);
  }
  const double angle = std::atan2(sine, cosine);
  return angle < 0.0 ? angle + FullTurn : angle;
}

/// The interior angles at a face's corners; those of a triangle share their sine, and their sum
/// saves the third inverse function.
void computeAngles(const SurfaceMesh& mesh, Index face, const Vec3& normal, double* angles)
{
  const Index size = mesh.faceSize(face);
  if (size != 3)
  {
    for (Index k = 0; k < size; ++k)
    {
      angles[k] = interiorAngle(mesh, face, k, normal);
    }
    return;
  }
  const Vec3 ab = mesh.facePoint(face, 1) - mesh.facePoint(face, 0);
  const Vec3 bc = mesh.facePoint(face, 2) - mesh.facePoint(face, 1);
  const Vec3 ca = mesh.facePoint(face, 0) - mesh.facePoint(face, 2);
  const double sine = ab.cross(bc).norm();
  angles[0] = std::atan2(sine, -ca.dot(ab));
  angles[1] = std::atan2(sine, -ab.dot(bc));
  angles[2] = 0.5 * FullTurn - angles[0] - angles[1];
}

} // namespace

std::vector<Vec3> angleWeightedNormals(
  const SurfaceMesh& mesh, const MeshTopology& topology, const Execution& execution)
{
  const auto at = [](auto i) { return static_cast<std::size_t>(i); };
  std::vector<Vec3> faceNormals(at(mesh.faceCount()));
  std::vector<double> angles(at(mesh.cornerCount()));
  execution.forRange(mesh.faceCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto face = static_cast<Index>(begin); face < static_cast<Index>(end); ++face)
      {
        faceNormals[at(face)] = faceNormal(mesh, face);
        double* const own = angles.data() + mesh.faceOffsets[at(face)];
        computeAngles(mesh, face, faceNormals[at(face)], own);
      }
    });
  std::vector<Vec3> normals(mesh.points.size());
  execution.forRange(mesh.vertexCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v)
      {
        Vec3 sum = Vec3::Zero();
        for (const Index corner : topology.ringCorners(v))
        {
          sum += angles[at(corner)] * faceNormals[at(topology.faceOf(corner))];
        }
        normals[at(v)] = normalizedOrZero(sum);
      }
    });
  return normals;
}

std::vector<Vec3> angleWeightedNormals(const SurfaceMesh& mesh)
{
  std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Vec3 normal = faceNormal(mesh, face);
    for (Index k = 0; k < mesh.faceSize(face); ++k)
    {
      normals[static_cast<std::size_t>(mesh.faceVertex(face, k))] +=
        interiorAngle(mesh, face, k, normal) * normal;
    }
  }
  for (Vec3& normal : normals)
  {
    normal = normalizedOrZero(normal);
  }
  return normals;
}

} // namespace evolving
