// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/SurfaceGradient.h"

#include "Operators/Discretization.h"
#include "Operators/SurfaceGeometry.h"
#include "Shapes/Sheets.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

TEST(SurfaceGradient, IsExactForLinearFunctionsInThePlane)
{
  const Vec3 slope(0.7, -1.3, 0.0);
  for (const bool triangles : { true, false })
  {
    const Discretization d(shapes::shakenSheet(6, triangles, 0.35, 8));
    std::vector<double> values;
    for (const Vec3& p : d.mesh.points)
    {
      values.push_back(slope.dot(p) + 4.0);
    }
    for (const Vec3& gradient : surfaceGradient(d.mesh, d.volumes, values, Execution()))
    {
      EXPECT_LT((gradient - slope).norm(), 1e-12);
    }
  }
}

TEST(SurfaceGradient, AgreesWithTheBoundaryIntegral)
{
  // (4.27) with the weights 5/12, 5/12, 2/12 at the midpoints of the co-volume's edges.
  double last = 0.0;
  for (const int level : { 2, 3, 4 })
  {
    const Discretization d(icosphere(level));
    std::vector<double> psi;
    for (const Vec3& p : d.mesh.points)
    {
      psi.push_back(p.x() * p.y() + std::sin(2.0 * p.z()));
    }
    const auto h = d.volumes.curvatureVectors(d.mesh, Execution());
    const auto gradient = surfaceGradient(d.mesh, d.volumes, psi, Execution());
    double difference = 0.0;
    double size = 0.0;
    for (Index i = 0; i < d.mesh.vertexCount(); ++i)
    {
      const auto v = static_cast<std::size_t>(i);
      const Vec3& F = d.mesh.points[v];
      Vec3 integral = Vec3::Zero();
      for (const Index corner : d.topology.ringCorners(i))
      {
        const auto p = static_cast<std::size_t>(d.topology.vertexOf(d.topology.next(corner)));
        const auto q = static_cast<std::size_t>(d.topology.vertexOf(d.topology.previous(corner)));
        const Vec3 B = (F + d.mesh.points[p] + d.mesh.points[q]) / 3.0;
        const auto edge = [&](const Vec3& neighbour, double value)
        {
          const Vec3 M = 0.5 * (F + neighbour);
          const Vec3 sigma = B - M;
          const Vec3 e = M - F;
          const Vec3 nu = (e - e.dot(sigma) / sigma.dot(sigma) * sigma).normalized();
          integral += sigma.norm() * value * nu;
        };
        edge(d.mesh.points[p], (5.0 * psi[v] + 5.0 * psi[p] + 2.0 * psi[q]) / 12.0);
        edge(d.mesh.points[q], (5.0 * psi[v] + 2.0 * psi[p] + 5.0 * psi[q]) / 12.0);
      }
      const Vec3 oracle = integral / d.volumes.coVolumes()[v] - psi[v] * h[v];
      difference += (tangentialPart(oracle - gradient[v], F)).squaredNorm();
      size += gradient[v].squaredNorm();
    }
    const double relative = std::sqrt(difference / size);
    EXPECT_LT(relative, last > 0.0 ? 0.6 * last : 0.02);
    last = relative;
  }
}
