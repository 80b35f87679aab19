// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TestShapes.h"

#include "Mesh/SurfaceMesh.h"

#include <cmath>
#include <map>
#include <utility>

namespace evolving
{

namespace
{

constexpr double Pi = 3.141592653589793;

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

SurfaceMesh splitOnSphere(const SurfaceMesh& coarse)
{
  SurfaceMesh fine;
  fine.points = coarse.points;
  std::map<std::pair<Index, Index>, Index> midpoints;
  const auto midpoint = [&](Index a, Index b)
  {
    const auto key = std::minmax(a, b);
    const auto found = midpoints.find(key);
    if (found != midpoints.end())
    {
      return found->second;
    }
    const Vec3 sum =
      fine.points[static_cast<std::size_t>(a)] + fine.points[static_cast<std::size_t>(b)];
    return midpoints[key] = fine.addPoint(sum.normalized());
  };
  for (Index face = 0; face < coarse.faceCount(); ++face)
  {
    const auto v = [&](Index k) { return coarse.faceVertex(face, k); };
    const std::array<Index, 3> m{ midpoint(v(0), v(1)), midpoint(v(1), v(2)),
      midpoint(v(2), v(0)) };
    fine.addFace({ v(0), m[0], m[2] });
    fine.addFace({ v(1), m[1], m[0] });
    fine.addFace({ v(2), m[2], m[1] });
    fine.addFace({ m[0], m[1], m[2] });
  }
  return fine;
}

} // namespace

SurfaceMesh makeMesh(const std::vector<Vec3>& points, const std::vector<std::vector<Index>>& faces)
{
  SurfaceMesh mesh;
  mesh.points = points;
  for (const std::vector<Index>& face : faces)
  {
    mesh.addFace(face);
  }
  return mesh;
}

SurfaceMesh cornerTetrahedron()
{
  return makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } });
}

SurfaceMesh unitCube()
{
  return cellSurface({ { 0, 0, 0 } });
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

SurfaceMesh torus(Index around, Index across, double ringRadius, double tubeRadius)
{
  SurfaceMesh mesh;
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const double u = 2.0 * Pi * i / around;
      const double v = 2.0 * Pi * j / across;
      const double radius = ringRadius + tubeRadius * std::cos(v);
      mesh.addPoint({ radius * std::cos(u), radius * std::sin(u), tubeRadius * std::sin(v) });
    }
  }
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const Index nextI = (i + 1) % around;
      const Index nextJ = (j + 1) % across;
      mesh.addFace(
        { i * across + j, nextI * across + j, nextI * across + nextJ, i * across + nextJ });
    }
  }
  return mesh;
}

SurfaceMesh annulus(Index count)
{
  SurfaceMesh mesh;
  for (Index i = 0; i < 2 * count; ++i)
  {
    const double angle = 2.0 * Pi * (i / 2) / count;
    const double radius = 1.0 + i % 2;
    mesh.addPoint({ radius * std::cos(angle), radius * std::sin(angle), 0.0 });
  }
  for (Index i = 0; i < count; ++i)
  {
    const Index next = (i + 1) % count;
    mesh.addFace({ 2 * i, 2 * i + 1, 2 * next + 1, 2 * next });
  }
  return mesh;
}

SurfaceMesh disc(Index count)
{
  SurfaceMesh mesh;
  mesh.addPoint(Vec3::Zero());
  for (Index i = 0; i < count; ++i)
  {
    mesh.addPoint({ std::cos(2.0 * Pi * i / count), std::sin(2.0 * Pi * i / count), 0.0 });
  }
  for (Index i = 0; i < count; ++i)
  {
    mesh.addFace({ 0, 1 + i, 1 + (i + 1) % count });
  }
  return mesh;
}

SurfaceMesh moebiusBand(Index count)
{
  SurfaceMesh mesh;
  for (Index i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    const Vec3 outwards(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 across = std::cos(angle / 2) * outwards + std::sin(angle / 2) * Vec3::UnitZ();
    mesh.addPoint(2.0 * outwards - 0.5 * across);
    mesh.addPoint(2.0 * outwards + 0.5 * across);
  }
  for (Index i = 0; i + 1 < count; ++i)
  {
    mesh.addFace({ 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2 });
  }
  mesh.addFace({ 2 * count - 2, 2 * count - 1, 0, 1 });
  return mesh;
}

SurfaceMesh cellSurface(const std::set<std::array<int, 3>>& cells)
{
  SurfaceMesh mesh;
  std::map<std::array<int, 3>, Index> numbers;
  const auto vertex = [&](const std::array<int, 3>& p)
  {
    const auto inserted = numbers.emplace(p, mesh.vertexCount());
    return inserted.second ? mesh.addPoint(Vec3(p[0], p[1], p[2])) : inserted.first->second;
  };
  for (const std::array<int, 3>& cell : cells)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const int side : { 0, 1 })
      {
        std::array<int, 3> beyond = cell;
        beyond[axis] += side == 0 ? -1 : 1;
        if (cells.count(beyond) != 0)
        {
          continue;
        }
        std::array<int, 3> corner = cell;
        corner[axis] += side;
        const std::size_t u = (axis + (side == 0 ? 2 : 1)) % 3;
        const std::size_t v = (axis + (side == 0 ? 1 : 2)) % 3;
        std::vector<Index> face{ vertex(corner) };
        corner[u] += 1;
        face.push_back(vertex(corner));
        corner[v] += 1;
        face.push_back(vertex(corner));
        corner[u] -= 1;
        face.push_back(vertex(corner));
        mesh.addFace(face);
      }
    }
  }
  return mesh;
}

SurfaceMesh slabWithHoles(int holes)
{
  std::set<std::array<int, 3>> cells;
  for (int i = 0; i < 2 * holes + 1; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (i % 2 == 0 || j != 1)
      {
        cells.insert({ i, j, 0 });
      }
    }
  }
  return cellSurface(cells);
}

SurfaceMesh triangleSheet(Index rows, Index columns)
{
  SurfaceMesh mesh;
  for (Index i = 0; i < rows; ++i)
  {
    for (Index j = 0; j < columns; ++j)
    {
      mesh.addPoint(Vec3(i, j, 0.0));
    }
  }
  for (Index i = 0; i + 1 < rows; ++i)
  {
    for (Index j = 0; j + 1 < columns; ++j)
    {
      const Index v = i * columns + j;
      mesh.addFace({ v, v + columns, v + columns + 1 });
      mesh.addFace({ v, v + columns + 1, v + 1 });
    }
  }
  return mesh;
}

} // namespace evolving
