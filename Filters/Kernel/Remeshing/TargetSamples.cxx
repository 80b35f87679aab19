// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/TargetSamples.h"

#include <cmath>

namespace evolving
{

namespace
{

/// 1 / g and 1 / g^2 for the plastic number g = 1.3247...
constexpr double FirstStep = 0.7548776662466927;
constexpr double SecondStep = 0.5698402909980532;

double fraction(double x)
{
  return x - std::floor(x);
}

} // namespace

Vec3 sampleOf(const Triangle& triangle, GridIndex i)
{
  double u = fraction(1.0 / 3.0 + static_cast<double>(i) * FirstStep);
  double v = fraction(1.0 / 3.0 + static_cast<double>(i) * SecondStep);
  if (u + v > 1.0)
  {
    u = 1.0 - u;
    v = 1.0 - v;
  }
  return triangle.corners[0] + u * (triangle.corners[1] - triangle.corners[0]) +
    v * (triangle.corners[2] - triangle.corners[0]);
}

std::vector<Vec3> samplesOf(const SurfaceMesh& triangles, double spacing)
{
  std::vector<Vec3> samples = triangles.points;
  double due = 0.5;
  for (Index face = 0; face < triangles.faceCount(); ++face)
  {
    const Triangle triangle = triangleOf(triangles, face);
    due += 0.5 * triangle.doubleAreaNormal().norm() / (spacing * spacing);
    const auto count = static_cast<GridIndex>(due);
    due -= static_cast<double>(count);
    for (GridIndex i = 0; i < count; ++i)
    {
      samples.push_back(sampleOf(triangle, i));
    }
  }
  return samples;
}

} // namespace evolving
