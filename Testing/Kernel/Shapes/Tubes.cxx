// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/Tubes.h"

#include "Mesh/Angles.h"
#include "Shapes/MeshVariants.h"

#include <cmath>
#include <functional>

namespace evolving::shapes
{

SurfaceMesh torus(Index around, Index across, double ringRadius, double tubeRadius)
{
  return fanned(quadTorus(around, across, ringRadius, tubeRadius));
}

SurfaceMesh quadTorus(Index around, Index across, double ringRadius, double tubeRadius)
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

SurfaceMesh tube(
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

SurfaceMesh openCylinder(Index around, Index rows, double radius, double height)
{
  SurfaceMesh mesh;
  for (Index i = 0; i <= rows; ++i)
  {
    for (Index j = 0; j < around; ++j)
    {
      const double angle = 2.0 * Pi * j / around;
      mesh.addPoint({ radius * std::cos(angle), radius * std::sin(angle), height * i / rows });
    }
  }
  for (Index i = 0; i < rows; ++i)
  {
    for (Index j = 0; j < around; ++j)
    {
      const Index here = i * around;
      const Index next = (j + 1) % around;
      mesh.addFace({ here + j, here + next, here + around + next });
      mesh.addFace({ here + j, here + around + next, here + around + j });
    }
  }
  return mesh;
}

SurfaceMesh moebiusBand(Index count, double radius, double halfWidth)
{
  SurfaceMesh mesh;
  for (Index i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    const Vec3 outwards(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 across = std::cos(angle / 2) * outwards + std::sin(angle / 2) * Vec3::UnitZ();
    mesh.addPoint(radius * outwards - halfWidth * across);
    mesh.addPoint(radius * outwards + halfWidth * across);
  }
  for (Index i = 0; i + 1 < count; ++i)
  {
    mesh.addFace({ 2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2 });
  }
  mesh.addFace({ 2 * count - 2, 2 * count - 1, 0, 1 });
  return mesh;
}

SurfaceMesh kleinBottle(Index around, Index across)
{
  SurfaceMesh mesh;
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      const double u = 2.0 * Pi * i / around;
      const double v = 2.0 * Pi * (j + 0.5) / across;
      const double a = 0.4 * std::sin(v);
      const double b = 0.4 * std::sin(2.0 * v);
      const double r = 1.0 + std::cos(u / 2) * a - std::sin(u / 2) * b;
      mesh.addPoint(
        Vec3(r * std::cos(u), r * std::sin(u), std::sin(u / 2) * a + std::cos(u / 2) * b));
    }
  }
  // After a full turn v has become -v.
  const auto number = [=](Index i, Index j)
  { return i < around ? i * across + j % across : across - 1 - j % across; };
  for (Index i = 0; i < around; ++i)
  {
    for (Index j = 0; j < across; ++j)
    {
      mesh.addFace({ number(i, j), number(i + 1, j), number(i + 1, j + 1) });
      mesh.addFace({ number(i, j), number(i + 1, j + 1), number(i, j + 1) });
    }
  }
  return mesh;
}

} // namespace evolving::shapes
