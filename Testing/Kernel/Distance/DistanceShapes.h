// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Meshes of known shape for tests of distances.
 */

#ifndef EVOLVING_DISTANCE_SHAPES_H
#define EVOLVING_DISTANCE_SHAPES_H

#include "Mesh/SurfaceMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace evolving::test
{

constexpr double Pi = 3.14159265358979323846;

/// One triangle.
inline SurfaceMesh triangleMesh(const Vec3& a, const Vec3& b, const Vec3& c)
{
  SurfaceMesh mesh;
  mesh.points = { a, b, c };
  mesh.addFace({ 0, 1, 2 });
  return mesh;
}

/// A box of 12 triangles.
inline SurfaceMesh box(const Vec3& low, const Vec3& high)
{
  SurfaceMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    mesh.addPoint(Vec3((corner & 1) ? high.x() : low.x(), (corner & 2) ? high.y() : low.y(),
      (corner & 4) ? high.z() : low.z()));
  }
  for (const auto& [a, b, c, d] : { std::array<Index, 4>{ 0, 2, 3, 1 }, { 4, 5, 7, 6 },
         { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
  {
    mesh.addFace({ a, b, c });
    mesh.addFace({ a, c, d });
  }
  return mesh;
}

inline SurfaceMesh octahedron()
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0, 1),
    Vec3(0, 0, -1) };
  for (const Index x : { 0, 1 })
  {
    for (const Index y : { 2, 3 })
    {
      for (const Index z : { 4, 5 })
      {
        const bool even = (x + y + z) % 2 == 0;
        mesh.addFace({ x, even ? y : z, even ? z : y });
      }
    }
  }
  return mesh;
}

/// An octahedron whose triangles were divided into four `level` times, points on the sphere.
inline SurfaceMesh sphere(int level, double radius = 1.0, const Vec3& center = Vec3::Zero())
{
  SurfaceMesh mesh = octahedron();
  for (int l = 0; l < level; ++l)
  {
    SurfaceMesh finer;
    finer.points = mesh.points;
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b)
    {
      const auto [entry, isNew] = middles.try_emplace(std::minmax(a, b), finer.vertexCount());
      if (isNew)
      {
        const auto i = static_cast<std::size_t>(a);
        const auto j = static_cast<std::size_t>(b);
        finer.addPoint((mesh.points[i] + mesh.points[j]).normalized());
      }
      return entry->second;
    };
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      const Index a = mesh.faceVertex(face, 0);
      const Index b = mesh.faceVertex(face, 1);
      const Index c = mesh.faceVertex(face, 2);
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      finer.addFace({ a, ab, ca });
      finer.addFace({ ab, b, bc });
      finer.addFace({ ca, bc, c });
      finer.addFace({ ab, bc, ca });
    }
    mesh = std::move(finer);
  }
  for (Vec3& point : mesh.points)
  {
    point = center + radius * point;
  }
  return mesh;
}

/// A torus around the z-axis of 2 around x across triangles.
inline SurfaceMesh torus(double ringRadius, double tubeRadius, int around, int across)
{
  SurfaceMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2.0 * Pi * i / around;
      const double v = 2.0 * Pi * j / across;
      const double r = ringRadius + tubeRadius * std::cos(v);
      mesh.addPoint(Vec3(r * std::cos(u), r * std::sin(u), tubeRadius * std::sin(v)));
    }
  }
  const auto number = [=](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      mesh.addFace({ number(i, j), number(i + 1, j), number(i + 1, j + 1) });
      mesh.addFace({ number(i, j), number(i + 1, j + 1), number(i, j + 1) });
    }
  }
  return mesh;
}

/// Triangles with independent corners in [-1, 1]^3; every eighth is a segment or a point.
inline SurfaceMesh randomSoup(int count, double size, std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  SurfaceMesh mesh;
  for (int t = 0; t < count; ++t)
  {
    const Vec3 a = vector();
    const Vec3 b = t % 16 == 15 ? a : Vec3(a + size * vector());
    const Vec3 c = t % 8 == 7 ? Vec3(0.5 * (a + b)) : Vec3(a + size * vector());
    mesh.addFace({ mesh.addPoint(a), mesh.addPoint(b), mesh.addPoint(c) });
  }
  return mesh;
}

/// The faces of a mesh reversed, all or those for which `chosen` is true.
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

inline SurfaceMesh insideOut(const SurfaceMesh& mesh)
{
  return turned(mesh, [](Index) { return true; });
}

/// Two meshes in one.
inline SurfaceMesh merged(SurfaceMesh first, const SurfaceMesh& second)
{
  const Index offset = first.vertexCount();
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  for (Index face = 0; face < second.faceCount(); ++face)
  {
    std::vector<Index> vertices;
    for (Index k = 0; k < second.faceSize(face); ++k)
    {
      vertices.push_back(offset + second.faceVertex(face, k));
    }
    first.addFace(vertices);
  }
  return first;
}

/// A mesh without the faces for which `dropped` is true; points stay.
template <typename Dropped>
SurfaceMesh without(const SurfaceMesh& mesh, const Dropped& dropped)
{
  SurfaceMesh result;
  result.points = mesh.points;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (!dropped(face))
    {
      std::vector<Index> vertices;
      for (Index k = 0; k < mesh.faceSize(face); ++k)
      {
        vertices.push_back(mesh.faceVertex(face, k));
      }
      result.addFace(vertices);
    }
  }
  return result;
}

/// A sphere without its cap above a height (of radius 1): open.
inline SurfaceMesh bowl(int level, double height)
{
  const SurfaceMesh whole = sphere(level);
  return without(whole,
    [&](Index face)
    {
      return whole.facePoint(face, 0).z() > height && whole.facePoint(face, 1).z() > height &&
        whole.facePoint(face, 2).z() > height;
    });
}

} // namespace evolving::test

#endif
