// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A surface of any size to time the evolution on: smooth, without symmetry, not convex.
 */

#ifndef BENCHMARK_BUMPY_SPHERE_H
#define BENCHMARK_BUMPY_SPHERE_H

#include "StartSurface/PrimitiveSurfaces.h"

#include <cmath>

namespace benchmark
{

/// An icosphere of 10 * 4^level + 2 vertices with bumps and dents.
inline evolving::SurfaceMesh bumpySphere(int level)
{
  evolving::SurfaceMesh mesh = evolving::icosphere(level);
  for (evolving::Vec3& p : mesh.points)
  {
    p *= 1.0 + 0.15 * std::sin(4.0 * p.x() + 0.5) * std::cos(3.0 * p.y()) +
      0.1 * std::sin(5.0 * p.z() + 1.0);
  }
  return mesh;
}

/// The time step that belongs to the size of the elements: the mean co-volume.
inline double meanCoVolume(const evolving::SurfaceMesh& mesh)
{
  return evolving::surfaceArea(mesh) / static_cast<double>(mesh.points.size());
}

/// Of the icosphere that has so many vertices, or the next larger one.
inline int levelOfVertices(int vertices)
{
  int level = 0;
  while (10 * std::pow(4.0, level) + 2 < vertices)
  {
    ++level;
  }
  return level;
}

} // namespace benchmark

#endif
