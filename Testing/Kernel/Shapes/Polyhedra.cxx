// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Polyhedra.h"

#include "Mesh/Angles.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "StartSurface/QuadSplitting.h"

#include <array>
#include <cmath>
#include <map>
#include <set>

namespace evolving::shapes
{

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

SurfaceMesh triangleMesh(const Vec3& a, const Vec3& b, const Vec3& c)
{
  SurfaceMesh mesh;
  mesh.points = { a, b, c };
  mesh.addFace({ 0, 1, 2 });
  return mesh;
}

SurfaceMesh cornerTetrahedron()
{
  return makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } });
}

SurfaceMesh regularTetrahedron()
{
  return makeMesh({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } });
}

SurfaceMesh octahedron()
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

SurfaceMesh unitCube()
{
  return cellSurface({ { 0, 0, 0 } });
}

SurfaceMesh box(const Vec3& low, const Vec3& high)
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

SurfaceMesh triangleBox(int divisions, const Vec3& halfSides)
{
  return splitQuads(subdividedBox(divisions, halfSides));
}

SurfaceMesh hexagonalPrism()
{
  SurfaceMesh mesh;
  for (const double z : { 0.0, 0.7 })
  {
    for (int k = 0; k < 6; ++k)
    {
      mesh.addPoint(Vec3(std::cos(k * Pi / 3.0), std::sin(k * Pi / 3.0), z));
    }
  }
  mesh.addFace({ 5, 4, 3, 2, 1, 0 });
  mesh.addFace({ 6, 7, 8, 9, 10, 11 });
  for (Index k = 0; k < 6; ++k)
  {
    mesh.addFace({ k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6 });
  }
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

} // namespace evolving::shapes
