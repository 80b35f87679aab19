// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Spheres.h"

#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Shapes/Draws.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <cmath>
#include <random>

namespace evolving::shapes
{

namespace
{

SurfaceMesh icosahedron()
{
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  SurfaceMesh mesh = makeMesh(
    { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g }, { 0, 1, g },
      { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 }, { -g, 0, 1 } },
    { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 },
      { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 },
      { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
      { 9, 8, 1 } });
  for (Vec3& point : mesh.points)
  {
    point.normalize();
  }
  return mesh;
}

/// Every triangle in four, the middles of edges on the unit sphere.
SurfaceMesh splitOnSphere(const SurfaceMesh& coarse)
{
  return quartered(coarse, [](const Vec3& a, const Vec3& b) { return Vec3((a + b).normalized()); });
}

} // namespace

SurfaceMesh sphere(int level, double radius, const Vec3& center)
{
  SurfaceMesh mesh = octahedron();
  for (int step = 0; step < level; ++step)
  {
    mesh = splitOnSphere(mesh);
  }
  return transformed(mesh, radius, center);
}

SurfaceMesh unitIcosphere(int level)
{
  SurfaceMesh mesh = icosahedron();
  for (int i = 0; i < level; ++i)
  {
    mesh = splitOnSphere(mesh);
  }
  return mesh;
}

SurfaceMesh ellipsoid(int level, const Vec3& halfAxes)
{
  SurfaceMesh mesh = icosphere(level);
  for (Vec3& point : mesh.points)
  {
    point = point.cwiseProduct(halfAxes);
  }
  return mesh;
}

SurfaceMesh bumpySphere(int level)
{
  SurfaceMesh mesh = icosphere(level);
  for (Vec3& p : mesh.points)
  {
    p *= 1.0 + 0.2 * std::sin(3.0 * p.x()) * std::cos(2.0 * p.y() + 1.0) +
      0.1 * std::sin(5.0 * p.z() + 0.3);
  }
  return mesh;
}

SurfaceMesh unevenSphere(int level)
{
  SurfaceMesh mesh = icosphere(level);
  std::mt19937 random(62);
  std::uniform_real_distribution<double> shift(-0.15, 0.15);
  const double edge = 1.1 * std::pow(0.5, level);
  for (Vec3& p : mesh.points)
  {
    p += edge * drawnVector(shift, random);
    p = (p + Vec3(0.3, 0.2, 0.45)).normalized();
  }
  return mesh;
}

SurfaceMesh shakenSphere(int level, double fraction, unsigned seed)
{
  const SurfaceMesh sphere = icosphere(level);
  SurfaceMesh mesh = shaken(sphere, fraction * meanEdgeLength(sphere), seed);
  for (Vec3& p : mesh.points)
  {
    p.normalize();
  }
  return mesh;
}

SurfaceMesh bowl(int level, double height)
{
  const SurfaceMesh whole = sphere(level);
  return without(whole,
    [&](Index face)
    {
      return whole.facePoint(face, 0).z() > height && whole.facePoint(face, 1).z() > height &&
        whole.facePoint(face, 2).z() > height;
    });
}

SurfaceMesh halfSphere(Index rings)
{
  SurfaceMesh mesh = disc(rings);
  for (Vec3& p : mesh.points)
  {
    const double angle = 0.5 * Pi * p.norm();
    p = Vec3(p.normalized() * std::sin(angle)) + Vec3(0.0, 0.0, std::cos(angle));
  }
  return mesh;
}

} // namespace evolving::shapes
