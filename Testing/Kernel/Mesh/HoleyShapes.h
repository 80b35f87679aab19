// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surfaces with holes for the tests.
 */

#ifndef EVOLVING_TESTING_HOLEY_SHAPES_H
#define EVOLVING_TESTING_HOLEY_SHAPES_H

#include "Mesh/SurfaceMesh.h"
#include "Mesh/TestShapes.h"

#include <cmath>
#include <vector>

namespace evolving
{
namespace testing_holes
{

constexpr double Pi = 3.141592653589793;

/// The faces for which keep(centroid) holds, and all points.
template <typename Keep>
SurfaceMesh facesWhere(const SurfaceMesh& mesh, const Keep& keep)
{
  SurfaceMesh result;
  result.points = mesh.points;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    std::vector<Index> vertices;
    Vec3 centroid = Vec3::Zero();
    for (Index k = 0; k < mesh.faceSize(face); ++k)
    {
      vertices.push_back(mesh.faceVertex(face, k));
      centroid += mesh.facePoint(face, k) / mesh.faceSize(face);
    }
    if (keep(centroid))
    {
      result.addFace(vertices);
    }
  }
  return result;
}

/// A unit sphere without what lies within an angle of the given directions.
inline SurfaceMesh drilledSphere(const std::vector<Vec3>& directions, double angle, int level = 4)
{
  return facesWhere(unitIcosphere(level),
    [&](const Vec3& p)
    {
      for (const Vec3& direction : directions)
      {
        if (p.normalized().dot(direction.normalized()) > std::cos(angle))
        {
          return false;
        }
      }
      return true;
    });
}

/// The side of a cylinder about the z axis, without its ends.
inline SurfaceMesh openCylinder(Index around, Index rows, double radius, double height)
{
  SurfaceMesh mesh;
  for (Index i = 0; i <= rows; ++i)
  {
    for (Index j = 0; j < around; ++j)
    {
      const double angle = 2.0 * Pi * j / around;
      mesh.addPoint({ radius * std::cos(angle), radius * std::sin(angle), height * i / rows });
    }
  }
  for (Index i = 0; i < rows; ++i)
  {
    for (Index j = 0; j < around; ++j)
    {
      const Index here = i * around;
      const Index next = (j + 1) % around;
      mesh.addFace({ here + j, here + next, here + around + next });
      mesh.addFace({ here + j, here + around + next, here + around + j });
    }
  }
  return mesh;
}

/// A square sheet of 2 n^2 triangles and side 1 in the plane z = 0, without a square in its middle.
inline SurfaceMesh sheetWithHole(Index n, double holeSide)
{
  SurfaceMesh mesh = triangleSheet(n + 1, n + 1);
  for (Vec3& point : mesh.points)
  {
    point = point / n - Vec3(0.5, 0.5, 0.0);
  }
  return facesWhere(mesh, [&](const Vec3& p) { return p.cwiseAbs().maxCoeff() > 0.5 * holeSide; });
}

} // namespace testing_holes
} // namespace evolving

#endif
