// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Sheets.h"

#include "Mesh/Angles.h"
#include "Shapes/Draws.h"

#include <cmath>
#include <random>

namespace evolving::shapes
{

SurfaceMesh sheet(Index n, bool triangles)
{
  SurfaceMesh mesh;
  for (Index j = 0; j <= n; ++j)
  {
    for (Index i = 0; i <= n; ++i)
    {
      mesh.addPoint(Vec3(static_cast<double>(i) / n, static_cast<double>(j) / n, 0.0));
    }
  }
  for (Index j = 0; j < n; ++j)
  {
    for (Index i = 0; i < n; ++i)
    {
      const Index a = j * (n + 1) + i;
      const Index b = a + n + 1;
      if (triangles)
      {
        mesh.addFace({ a, a + 1, b + 1 });
        mesh.addFace({ a, b + 1, b });
      }
      else
      {
        mesh.addFace({ a, a + 1, b + 1, b });
      }
    }
  }
  return mesh;
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

SurfaceMesh shakenSheet(Index n, bool triangles, double amount, unsigned seed)
{
  SurfaceMesh mesh = sheet(n, triangles);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amount / n, amount / n);
  for (Vec3& p : mesh.points)
  {
    const bool isInner = p.x() > 1e-9 && p.x() < 1.0 - 1e-9 && p.y() > 1e-9 && p.y() < 1.0 - 1e-9;
    p += isInner ? drawnInPlane(shift, random) : Vec3(Vec3::Zero());
  }
  return mesh;
}

SurfaceMesh disc(Index rings)
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

SurfaceMesh fan(Index count)
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

} // namespace evolving::shapes
