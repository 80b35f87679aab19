// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The same surface in other words, moved, joined with another or cut.
 */

#ifndef EVOLVING_TESTING_MESH_VARIANTS_H
#define EVOLVING_TESTING_MESH_VARIANTS_H

#include "Mesh/SurfaceMesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace evolving::shapes
{

/// The numbers of a face's corners.
std::vector<Index> faceVertices(const SurfaceMesh& mesh, Index face);

/// The mesh with the points mapped by p -> scale * p + offset.
SurfaceMesh transformed(SurfaceMesh mesh, double scale, const Vec3& offset);

/// The mesh with every point multiplied by a matrix.
SurfaceMesh mapped(SurfaceMesh mesh, const Eigen::Matrix3d& matrix);

/// A rotation that no mesh here is symmetric under.
Eigen::Matrix3d someRotation();

/// A rotation about a random axis by a random angle.
Eigen::Matrix3d randomRotation(std::mt19937& generator);

/// A point in the cube [-1, 1]^3.
Vec3 randomPoint(std::mt19937& generator);

/// All vertices moved by up to `amount` along each axis.
SurfaceMesh shaken(SurfaceMesh mesh, double amount, unsigned seed);

/// The inner vertices of a surface moved along x and y by up to `amount`.
SurfaceMesh shakenInside(SurfaceMesh mesh, double amount, unsigned seed);

/// The same surface with vertices, faces and the corners of each face in another order.
SurfaceMesh shuffled(const SurfaceMesh& mesh, std::mt19937& generator);

/// Every polygon cut into a fan of triangles about its first corner.
SurfaceMesh fanned(const SurfaceMesh& mesh);

/// Every polygon cut into a fan of triangles about a corner chosen at random.
SurfaceMesh triangulated(const SurfaceMesh& mesh, std::mt19937& generator);

/// Every face with points of its own, as in an STL file.
SurfaceMesh soupOf(const SurfaceMesh& mesh);

/// Two meshes in one, side by side, no vertex shared.
SurfaceMesh merged(SurfaceMesh first, const SurfaceMesh& second);

/// The mesh with those faces reversed for which `chosen` is true.
template <typename Chosen>
SurfaceMesh turned(SurfaceMesh mesh, const Chosen& chosen)
{
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (chosen(face))
    {
      const auto offset = static_cast<std::size_t>(face);
      std::reverse(mesh.cornerVertices.begin() + mesh.faceOffsets[offset],
        mesh.cornerVertices.begin() + mesh.faceOffsets[offset + 1]);
    }
  }
  return mesh;
}

/// The mesh without the faces for which `dropped` is true; points stay.
template <typename Dropped>
SurfaceMesh without(const SurfaceMesh& mesh, const Dropped& dropped)
{
  SurfaceMesh result;
  result.points = mesh.points;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (!dropped(face))
    {
      result.addFace(faceVertices(mesh, face));
    }
  }
  return result;
}

/// The faces for which keep(centroid) holds, and all points.
template <typename Keep>
SurfaceMesh facesWhere(const SurfaceMesh& mesh, const Keep& keep)
{
  return without(mesh,
    [&](Index face)
    {
      Vec3 centroid = Vec3::Zero();
      for (Index k = 0; k < mesh.faceSize(face); ++k)
      {
        centroid += mesh.facePoint(face, k) / mesh.faceSize(face);
      }
      return !keep(centroid);
    });
}

/// Every triangle in four; middle(a, b) is the new point of the edge between two points.
template <typename Middle>
SurfaceMesh quartered(const SurfaceMesh& coarse, const Middle& middle)
{
  SurfaceMesh fine;
  fine.points = coarse.points;
  std::map<std::pair<Index, Index>, Index> ofEdge;
  const auto between = [&](Index a, Index b)
  {
    const auto [entry, isNew] = ofEdge.try_emplace(std::minmax(a, b), fine.vertexCount());
    if (isNew)
    {
      fine.addPoint(middle(
        coarse.points[static_cast<std::size_t>(a)], coarse.points[static_cast<std::size_t>(b)]));
    }
    return entry->second;
  };
  for (Index face = 0; face < coarse.faceCount(); ++face)
  {
    const Index a = coarse.faceVertex(face, 0);
    const Index b = coarse.faceVertex(face, 1);
    const Index c = coarse.faceVertex(face, 2);
    const Index ab = between(a, b);
    const Index bc = between(b, c);
    const Index ca = between(c, a);
    fine.addFace({ a, ab, ca });
    fine.addFace({ b, bc, ab });
    fine.addFace({ c, ca, bc });
    fine.addFace({ ab, bc, ca });
  }
  return fine;
}

/// Triangles with independent corners in [-1, 1]^3; every eighth is a segment or a point.
SurfaceMesh randomSoup(int count, double size, std::uint32_t seed);

} // namespace evolving::shapes

#endif
