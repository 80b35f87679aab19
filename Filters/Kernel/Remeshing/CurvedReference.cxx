// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/CurvedReference.h"

#include "Mesh/MeshTopology.h"
#include "Mesh/VertexNormals.h"
#include "ParallelLoops.h"
#include "Remeshing/Barycentric.h"

#include <limits>

namespace evolving
{

namespace
{

constexpr double LeastCosine = 0.5;
constexpr double Bulge = 0.5;

} // namespace

CurvedReference::CurvedReference(const SurfaceMesh& triangles, const Execution& execution)
  : Mesh(triangles)
  , Tree(triangles, execution)
  , Normals(angleWeightedNormals(triangles, MeshTopology(triangles), execution))
{
}

ReferenceSurface::Foot CurvedReference::onSurface(
  const Vec3& point, const Vec3& /*facing*/, Index /*label*/, Index guess) const
{
  const ClosestTriangle closest =
    this->Tree.closest(point, std::numeric_limits<double>::infinity(), guess);
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
