// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Discs, distorted spheres and spheres of several kinds of polygons for the tests of the
 * evolution folder.
 */

#ifndef EVOLVING_ROUND_SHAPES_H
#define EVOLVING_ROUND_SHAPES_H

#include "Evolution/EvolutionShapes.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace evolving::shapes
{

/// The unit disc at z = 0 in rings of triangles; vertex 0 at the centre, 6 * rings on the boundary.
inline SurfaceMesh disc(Index rings)
{
  SurfaceMesh mesh;
  mesh.addPoint(Vec3::Zero());
  for (Index ring = 1; ring <= rings; ++ring)
  {
    const double radius = static_cast<double>(ring) / rings;
    for (Index k = 0; k < 6 * ring; ++k)
    {
      const double angle = Pi * k / (3.0 * ring);
      mesh.addPoint(Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.0));
    }
  }
  const auto number = [](Index ring, Index k)
  { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + k % (6 * ring); };
  for (Index ring = 1; ring <= rings; ++ring)
  {
    for (Index k = 0; k < 6 * ring; ++k)
    {
      const Index inner = k / ring * (ring - 1) + k % ring; // sextants have ring and ring - 1 edges
      mesh.addFace({ number(ring, k), number(ring, k + 1), number(ring - 1, inner) });
      if (k % ring + 1 < ring)
      {
        mesh.addFace({ number(ring, k + 1), number(ring - 1, inner + 1), number(ring - 1, inner) });
      }
    }
  }
  return mesh;
}

/// The upper half of the unit sphere, its boundary at z = 0.
inline SurfaceMesh halfSphere(Index rings)
{
  SurfaceMesh mesh = disc(rings);
  for (Vec3& p : mesh.points)
  {
    const double angle = 0.5 * Pi * p.norm();
    p = Vec3(p.normalized() * std::sin(angle)) + Vec3(0.0, 0.0, std::cos(angle));
  }
  return mesh;
}

/// The inner vertices of a surface moved along x and y by up to `amount`.
inline SurfaceMesh shakenInside(SurfaceMesh mesh, double amount, unsigned seed)
{
  const MeshTopology topology(mesh);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amount, amount);
  for (Index i = 0; i < mesh.vertexCount(); ++i)
  {
    const Vec3 move(shift(random), shift(random), 0.0);
    mesh.points[static_cast<std::size_t>(i)] += topology.isBoundary(i) ? Vec3(Vec3::Zero()) : move;
  }
  return mesh;
}

/// A rotation that no mesh here is symmetric under.
inline Eigen::Matrix3d someRotation()
{
  return Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
}

inline SurfaceMesh rotated(SurfaceMesh mesh, const Eigen::Matrix3d& rotation)
{
  for (Vec3& point : mesh.points)
  {
    point = rotation * point;
  }
  return mesh;
}

/**
 * The start of figure 6.2: the vertices of a unit sphere crowd at one side and lie unevenly
 * everywhere.
 */
inline SurfaceMesh unevenSphere(int level)
{
  SurfaceMesh mesh = icosphere(level);
  std::mt19937 random(62);
  std::uniform_real_distribution<double> shift(-0.15, 0.15);
  const double edge = 1.1 * std::pow(0.5, level);
  for (Vec3& p : mesh.points)
  {
    p += edge * Vec3(shift(random), shift(random), shift(random));
    p = (p + Vec3(0.3, 0.2, 0.45)).normalized();
  }
  return mesh;
}

/// Every `period`-th free vertex taken out, its triangles joined to one polygon: a mixed mesh.
inline SurfaceMesh withPolygons(const SurfaceMesh& triangles, Index period)
{
  const MeshTopology topology(triangles);
  std::vector<char> isJoined(static_cast<std::size_t>(triangles.faceCount()), 0);
  SurfaceMesh mesh;
  mesh.points = triangles.points;
  for (Index i = 0; i < triangles.vertexCount(); i += period)
  {
    const MeshTopology::Run corners = topology.ringCorners(i);
    const auto joined = [&](Index corner) -> char&
    { return isJoined[static_cast<std::size_t>(topology.faceOf(corner))]; };
    if (!topology.isBoundary(i) && std::none_of(corners.begin(), corners.end(), joined))
    {
      const MeshTopology::Run ring = topology.ringVertices(i);
      mesh.addFace(std::vector<Index>(ring.begin(), ring.end()));
      std::for_each(corners.begin(), corners.end(), [&](Index corner) { joined(corner) = 1; });
    }
  }
  for (Index face = 0; face < triangles.faceCount(); ++face)
  {
    if (!isJoined[static_cast<std::size_t>(face)])
    {
      mesh.addFace({ triangles.faceVertex(face, 0), triangles.faceVertex(face, 1),
        triangles.faceVertex(face, 2) });
    }
  }
  return weldCoincidentPoints(mesh); // drops the points that were taken out
}

/// A sphere of triangles, quads, pentagons and hexagons.
inline SurfaceMesh mixedSphere(int level)
{
  const SurfaceMesh mesh = withPolygons(icosphere(level), 2);
  const MeshTopology topology(mesh);
  std::vector<char> isJoined(static_cast<std::size_t>(mesh.faceCount()), 0);
  SurfaceMesh mixed;
  mixed.points = mesh.points;
  const auto isTriangle = [&](Index face)
  { return mesh.faceSize(face) == 3 && !isJoined[static_cast<std::size_t>(face)]; };
  for (Index corner = 0; corner < topology.cornerCount(); ++corner)
  {
    // Two triangles become a quad over the edge from vertex a to vertex b.
    const Index other = topology.opposite(corner);
    const Index face = topology.faceOf(corner);
    const Index neighbour = topology.faceOf(other);
    if (face % 3 == 0 && isTriangle(face) && isTriangle(neighbour))
    {
      mixed.addFace(
        { topology.vertexOf(topology.next(corner)), topology.vertexOf(topology.previous(corner)),
          topology.vertexOf(corner), topology.vertexOf(topology.previous(other)) });
      isJoined[static_cast<std::size_t>(face)] = 1;
      isJoined[static_cast<std::size_t>(neighbour)] = 1;
    }
  }
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (!isJoined[static_cast<std::size_t>(face)])
    {
      const auto begin =
        mesh.cornerVertices.begin() + mesh.faceOffsets[static_cast<std::size_t>(face)];
      mixed.addFace(std::vector<Index>(begin, begin + mesh.faceSize(face)));
    }
  }
  return mixed;
}

} // namespace evolving::shapes

#endif
