// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/CurvedReference.h"

#include "ParallelLoops.h"
#include "Trees/Barycentric.h"

#include <limits>

namespace evolving
{

namespace
{

/// Of the angle between the normals of a triangle and a corner of it: 30 degrees.
constexpr double LeastCosine = 0.866;
/// See the header: with one half the bulge is that of the surface to second order.
constexpr double Bulge = 0.5;

/**
 * Weighted so that they are exact where a vertex and its neighbours lie on a sphere (Max, *Weights
 * for Computing Vertex Normals from Facet Normals*, 1999): else the bulges would be of third order.
 */
std::vector<Vec3> sphericalNormals(const SurfaceMesh& triangles)
{
  std::vector<Vec3> normals(triangles.points.size(), Vec3::Zero());
  for (Index f = 0; f < triangles.faceCount(); ++f)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Vec3& corner = triangles.facePoint(f, k);
      const Vec3 forth = triangles.facePoint(f, (k + 1) % 3) - corner;
      const Vec3 back = triangles.facePoint(f, (k + 2) % 3) - corner;
      const double squares = forth.squaredNorm() * back.squaredNorm();
      normals[at(triangles.faceVertex(f, k))] +=
        squares > 0.0 ? Vec3(forth.cross(back) / squares) : Vec3(Vec3::Zero());
    }
  }
  for (Vec3& normal : normals)
  {
    normal.stableNormalize();
  }
  return normals;
}

} // namespace

CurvedReference::CurvedReference(const SurfaceMesh& triangles, const Execution& execution)
  : Mesh(triangles)
  , Tree(triangles, execution)
  , Normals(sphericalNormals(triangles))
{
}

ReferenceSurface::Foot CurvedReference::onSurface(
  const Vec3& point, const Vec3& facing, Index /*label*/, Index guess) const
{
  const ClosestTriangle closest =
    this->Tree.closest(point, std::numeric_limits<double>::infinity(), guess);
  if (closest.triangle == NoIndex)
  {
    return { point, facing, NoIndex };
  }
  const Triangle& triangle = this->Tree.triangle(closest.triangle);
  const Vec3 normal = triangle.doubleAreaNormal().stableNormalized();
  const Vec3 weights = barycentricCoordinates(triangle, closest.at.point);
  Vec3 bulge = Vec3::Zero();
  bool isSmooth = weights.allFinite();
  for (Index k = 0; isSmooth && k < 3; ++k)
  {
    const Vec3& corner = triangle.corners[at(k)];
    const Vec3& n = this->Normals[at(this->Mesh.faceVertex(closest.triangle, k))];
    isSmooth = n.dot(normal) > LeastCosine;
    bulge -= Bulge * weights[k] * (closest.at.point - corner).dot(n) * n;
  }
  return { isSmooth ? Vec3(closest.at.point + bulge) : closest.at.point, normal, closest.triangle };
}

} // namespace evolving
