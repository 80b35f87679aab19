// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/CreasedShapes.h"

#include "Mesh/Angles.h"
#include "Mesh/PolygonTriangulation.h"
#include "Shapes/Sheets.h"

#include <array>
#include <cmath>
#include <random>

namespace evolving::shapes
{

SurfaceMesh extruded(const std::vector<Vec3>& polygon, double height)
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

std::vector<Vec3> regularPolygon(int count, double radius)
{
  std::vector<Vec3> polygon;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  return polygon;
}

std::vector<Vec3> randomPolygon(std::mt19937& generator)
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

SurfaceMesh wedge()
{
  return extruded({ Vec3(0, 0, 0), Vec3(1.5, 0, 0), Vec3(0.75, 1.1, 0) }, 1.2);
}

SurfaceMesh blade(double degrees, double length, double height)
{
  const double width = length * std::tan(degrees * RadiansPerDegree);
  return extruded({ Vec3(0, 0, 0), Vec3(length, 0, 0), Vec3(length, width, 0) }, height);
}

SurfaceMesh ell()
{
  return extruded(
    { Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(1, 1, 0), Vec3(1, 2, 0), Vec3(0, 2, 0) },
    1.0);
}

SurfaceMesh cylinder()
{
  return extruded(regularPolygon(48), 1.5);
}

SurfaceMesh cone()
{
  constexpr Index Sides = 48;
  SurfaceMesh mesh;
  mesh.points = regularPolygon(Sides);
  const Index foot = mesh.addPoint(Vec3::Zero());
  const Index apex = mesh.addPoint(Vec3::UnitZ());
  for (Index i = 0; i < Sides; ++i)
  {
    const Index j = (i + 1) % Sides;
    mesh.addFace({ j, i, foot });
    mesh.addFace({ i, j, apex });
  }
  return mesh;
}

SurfaceMesh pyramid(Index sides, double degreesAround)
{
  SurfaceMesh mesh;
  const std::vector<Vec3> base = regularPolygon(static_cast<int>(sides));
  const double halfAngle = 0.5 * degreesAround / sides * RadiansPerDegree;
  const double slant = std::sin(Pi / sides) / std::sin(halfAngle); // base to tip
  mesh.addPoint(Vec3(0, 0, std::sqrt(slant * slant - 1.0)));
  const Index middle = mesh.addPoint(Vec3::Zero());
  mesh.points.insert(mesh.points.end(), base.begin(), base.end());
  for (Index k = 0; k < sides; ++k)
  {
    const Index a = 2 + k;
    const Index b = 2 + (k + 1) % sides;
    mesh.addFace({ 0, a, b });
    mesh.addFace({ middle, b, a });
  }
  return mesh;
}

SurfaceMesh boxWithDart()
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(-1, -1, -1.8), Vec3(1, -1, -1.8), Vec3(1, 1, -1.8), Vec3(-1, 1, -1.8),
    Vec3(-1, -1, -0.8), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, -0.8), Vec3(-1, 0, 0),
    Vec3(0, 0, 0) };
  const std::vector<std::array<Index, 3>> faces = { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 1, 2, 6 }, { 1, 6, 5 }, { 2, 3, 7 }, { 2, 7, 6 }, { 0, 4, 8 }, { 0, 8, 3 },
    { 3, 8, 7 }, { 9, 8, 4 }, { 9, 4, 5 }, { 9, 5, 6 }, { 9, 6, 7 }, { 9, 7, 8 } };
  for (const auto& [a, b, c] : faces)
  {
    mesh.addFace({ a, b, c });
  }
  return mesh;
}

SurfaceMesh chamferedCube(double width)
{
  return extruded(
    { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1 - width, 0), Vec3(1 - width, 1, 0), Vec3(0, 1, 0) },
    1.0);
}

SurfaceMesh fadingRidge(Index count)
{
  return heightField(count, [](double x, double y) { return -std::abs(y) * 0.5 * (1.0 - x); });
}

SurfaceMesh pressedWedge(Index count)
{
  const auto slope = [](double x)
  { return std::abs(x) < 0.6 ? std::pow(std::cos(Pi * x / 1.2), 2) : 0.0; };
  return heightField(
    count, [&](double x, double y) { return std::abs(y) * std::exp(-4.0 * y * y) * slope(x); });
}

} // namespace evolving::shapes
