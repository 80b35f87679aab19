// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Surfaces and images with known answers for the tests of the evolution folder.
 */

#ifndef EVOLVING_EVOLUTION_SHAPES_H
#define EVOLVING_EVOLUTION_SHAPES_H

#include "Evolution/EvolutionFields.h" // for callers: most flows need both
#include "Mesh/SurfaceMesh.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace evolving::shapes
{

inline constexpr double Pi = 3.14159265358979323846;

/// An icosphere stretched along the axes.
inline SurfaceMesh ellipsoid(int level, const Vec3& halfAxes)
{
  SurfaceMesh mesh = icosphere(level);
  for (Vec3& point : mesh.points)
  {
    point = point.cwiseProduct(halfAxes);
  }
  return mesh;
}

/// An icosphere with bumps, without any symmetry.
inline SurfaceMesh bumpySphere(int level)
{
  SurfaceMesh mesh = icosphere(level);
  for (Vec3& p : mesh.points)
  {
    p *= 1.0 + 0.2 * std::sin(3.0 * p.x()) * std::cos(2.0 * p.y() + 1.0) +
      0.1 * std::sin(5.0 * p.z() + 0.3);
  }
  return mesh;
}

/// n x n squares over [0, 1]^2, as quads or each cut into two triangles; (n + 1)^2 vertices.
inline SurfaceMesh sheet(Index n, bool triangles)
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

/// The inner vertices of sheet() moved within the plane by up to `amount` cells.
inline SurfaceMesh shakenSheet(Index n, bool triangles, double amount, unsigned seed)
{
  SurfaceMesh mesh = sheet(n, triangles);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-amount / n, amount / n);
  for (Vec3& p : mesh.points)
  {
    const bool isInner = p.x() > 1e-9 && p.x() < 1.0 - 1e-9 && p.y() > 1e-9 && p.y() < 1.0 - 1e-9;
    p += isInner ? Vec3(shift(random), shift(random), 0.0) : Vec3(Vec3::Zero());
  }
  return mesh;
}

/// A grid on a torus, closed both ways: triangles (valence 6) or quads (valence 4).
inline SurfaceMesh torusGrid(
  Index around, Index across, double ringRadius, double tubeRadius, bool triangles)
{
  SurfaceMesh mesh;
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const double u = 2.0 * Pi * i / around;
      const double v = 2.0 * Pi * j / across;
      const double r = ringRadius + tubeRadius * std::cos(v);
      mesh.addPoint(Vec3(r * std::cos(u), r * std::sin(u), tubeRadius * std::sin(v)));
    }
  }
  const auto number = [&](Index i, Index j) { return (i % around) * across + j % across; };
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const Index a = number(i, j);
      const Index b = number(i + 1, j);
      const Index c = number(i + 1, j + 1);
      const Index d = number(i, j + 1);
      if (triangles)
      {
        mesh.addFace({ a, b, c });
        mesh.addFace({ a, c, d });
      }
      else
      {
        mesh.addFace({ a, b, c, d });
      }
    }
  }
  return mesh;
}

/// A tube around z from -height to height: radius(z), triangles, two boundary circles.
inline SurfaceMesh tube(
  Index around, Index along, double height, const std::function<double(double)>& radius)
{
  SurfaceMesh mesh;
  for (Index k = 0; k <= along; ++k)
  {
    const double z = height * (2.0 * k / along - 1.0);
    for (Index i = 0; i < around; ++i)
    {
      const double angle = 2.0 * Pi * (i + 0.5 * (k % 2)) / around;
      mesh.addPoint(Vec3(radius(z) * std::cos(angle), radius(z) * std::sin(angle), z));
    }
  }
  for (Index k = 0; k < along; ++k)
  {
    for (Index i = 0; i < around; ++i)
    {
      const Index a = k * around + i;
      const Index b = k * around + (i + 1) % around;
      const Index shift = k % 2;
      const Index c = (k + 1) * around + (i + shift) % around;
      const Index d = (k + 1) * around + (i + 1 + shift) % around;
      if (shift == 0)
      {
        mesh.addFace({ a, b, c });
        mesh.addFace({ b, d, c });
      }
      else
      {
        mesh.addFace({ a, b, c });
        mesh.addFace({ a, c, (k + 1) * around + i });
      }
    }
  }
  return mesh;
}

/// A closed prism over a regular hexagon: two hexagons and six quads.
inline SurfaceMesh hexagonalPrism()
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

inline SurfaceMesh together(const SurfaceMesh& first, const SurfaceMesh& second)
{
  SurfaceMesh mesh = first;
  mesh.points.insert(mesh.points.end(), second.points.begin(), second.points.end());
  for (Index face = 0; face < second.faceCount(); ++face)
  {
    std::vector<Index> vertices;
    for (Index k = 0; k < second.faceSize(face); ++k)
    {
      vertices.push_back(second.faceVertex(face, k) + first.vertexCount());
    }
    mesh.addFace(vertices);
  }
  return mesh;
}

inline SurfaceMesh transformed(SurfaceMesh mesh, double scale, const Vec3& offset)
{
  for (Vec3& point : mesh.points)
  {
    point = scale * point + offset;
  }
  return mesh;
}

/// Standard deviation over mean.
inline double relativeSpread(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  const double mean = sum / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values)
  {
    squares += (value - mean) * (value - mean);
  }
  return std::sqrt(squares / static_cast<double>(values.size())) / mean;
}

} // namespace evolving::shapes

#endif
