// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Checks/WindingComparison.h"

#include "Distance/Signs/WindingNumber.h"
#include "Shapes/MeshVariants.h"

#include <cmath>
#include <random>

namespace evolving::checks
{

double windingAround(const SurfaceMesh& mesh, const Vec3& point)
{
  double sum = 0.0;
  for (const Triangle& triangle : trianglesOf(mesh))
  {
    sum += windingNumber(triangle, point);
  }
  return sum;
}

WindingComparison compareWinding(
  const SurfaceMesh& mesh, const SurfaceMesh& surface, int points, unsigned seed)
{
  std::mt19937 generator(seed);
  const Box box = boundingBox(mesh);
  WindingComparison found;
  for (int i = 0; i < points; ++i)
  {
    const Vec3 point =
      box.center() + 0.5 * box.sizes().cwiseProduct(shapes::randomPoint(generator));
    const bool isInside = std::abs(windingAround(mesh, point)) > 0.5;
    const double expected = isInside ? 1.0 : 0.0;
    found.inside += isInside ? 1 : 0;
    found.different += std::abs(windingAround(surface, point) - expected) > 0.01 ? 1 : 0;
  }
  return found;
}

} // namespace evolving::checks
