// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Shapes with known creases.
 */

#ifndef EVOLVING_FEATURE_SHAPES_H
#define EVOLVING_FEATURE_SHAPES_H

#include "Mesh/PolygonTriangulation.h"
#include "Mesh/SurfaceMesh.h"

#include <cmath>
#include <random>
#include <vector>

namespace evolving::test
{

/// A prism of triangles over a simple polygon in the plane z = 0, counter-clockwise.
inline SurfaceMesh extruded(const std::vector<Vec3>& polygon, double height)
{
  SurfaceMesh mesh;
  const auto n = static_cast<Index>(polygon.size());
  for (const double z : { 0.0, height })
  {
    for (const Vec3& point : polygon)
    {
      mesh.addPoint(point + Vec3(0, 0, z));
    }
  }
  for (const auto& [a, b, c] : triangulatePolygon(polygon))
  {
    mesh.addFace({ c, b, a });
    mesh.addFace({ n + a, n + b, n + c });
  }
  for (Index i = 0; i < n; ++i)
  {
    const Index j = (i + 1) % n;
    mesh.addFace({ i, j, n + j });
    mesh.addFace({ i, n + j, n + i });
  }
  return mesh;
}

inline std::vector<Vec3> regularPolygon(int count, double radius = 1.0)
{
  std::vector<Vec3> polygon;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / count;
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return polygon;
}

/// Star-shaped about the origin, with corners of all angles.
inline std::vector<Vec3> randomPolygon(std::mt19937& generator)
{
  std::uniform_int_distribution<int> count(3, 15);
  std::uniform_real_distribution<double> radius(0.4, 1.5);
  std::vector<Vec3> polygon = regularPolygon(count(generator));
  for (Vec3& point : polygon)
  {
    point *= radius(generator);
  }
  return polygon;
}

/// The triangles of a height over the square [-1, 1]^2, with count squares a side.
template <typename Height>
SurfaceMesh heightField(Index count, const Height& height)
{
  SurfaceMesh mesh;
  for (Index j = 0; j <= count; ++j)
  {
    for (Index i = 0; i <= count; ++i)
    {
      const double x = -1.0 + 2.0 * i / count;
      const double y = -1.0 + 2.0 * j / count;
      mesh.addPoint(Vec3(x, y, height(x, y)));
    }
  }
  for (Index j = 0; j < count; ++j)
  {
    for (Index i = 0; i < count; ++i)
    {
      const Index a = j * (count + 1) + i;
      const Index b = a + count + 1;
      mesh.addFace({ a, a + 1, b + 1 });
      mesh.addFace({ a, b + 1, b });
    }
  }
  return mesh;
}

/// Along y = 0 a ridge that fades out from x = -1 to x = 1: its fold is 2 atan((1 - x) / 2).
inline SurfaceMesh fadingRidge(Index count)
{
  return heightField(count, [](double x, double y) { return -std::abs(y) * 0.5 * (1.0 - x); });
}

/// Along y = 0 a valley that begins and ends inside.
inline SurfaceMesh pressedWedge(Index count)
{
  const auto slope = [](double x)
  { return std::abs(x) < 0.6 ? std::pow(std::cos(std::acos(-1.0) * x / 1.2), 2) : 0.0; };
  return heightField(
    count, [&](double x, double y) { return std::abs(y) * std::exp(-4.0 * y * y) * slope(x); });
}

} // namespace evolving::test

#endif
