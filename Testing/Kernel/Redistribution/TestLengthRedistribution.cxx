// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/LengthRedistribution.h"

#include "Checks/SurfaceMeasures.h"
#include "Mesh/Angles.h"
#include "Mesh/MeshTopology.h"
#include "Operators/SurfaceGeometry.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace evolving;

namespace
{

std::vector<double> segmentLengths(const VertexChain& chain, const std::vector<Vec3>& points)
{
  std::vector<double> lengths;
  for (Index k = 0; k < chain.edgeCount(); ++k)
  {
    lengths.push_back((points[static_cast<std::size_t>(chain.vertex(k + 1))] -
      points[static_cast<std::size_t>(chain.vertex(k))])
                        .norm());
  }
  return lengths;
}

std::vector<Vec3> unmoved(const SurfaceMesh& mesh)
{
  return std::vector<Vec3>(mesh.points.size(), Vec3::Zero());
}

} // namespace

TEST(LengthRedistribution, SpeedsEqualiseSegments)
{
  VertexChain chain;
  std::vector<Vec3> points;
  for (const double x : { 0.0, 0.1, 0.5, 0.6, 1.0 })
  {
    chain.vertices.push_back(static_cast<Index>(points.size()));
    points.emplace_back(x, 0.0, 0.0);
  }
  const std::vector<Vec3> still(5, Vec3::Zero());
  const std::vector<double> speed = chainSpeeds(chain, points, still, 1.0, 1e300);
  // With omega tau = 1 one step makes the segments equal.
  for (std::size_t k = 0; k < 5; ++k)
  {
    EXPECT_NEAR(points[k].x() + speed[k], 0.25 * static_cast<double>(k), 1e-14);
  }
}

TEST(LengthRedistribution, ClosedChainsDoNotDrift)
{
  VertexChain chain;
  chain.isClosed = true;
  std::vector<Vec3> points;
  std::vector<Vec3> velocity;
  for (const double angle : { 0.0, 0.4, 1.0, 2.0, 2.5, 4.0, 5.0 })
  {
    chain.vertices.push_back(static_cast<Index>(points.size()));
    points.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    velocity.emplace_back(std::sin(3.0 * angle), 1.0, 0.0);
  }
  const std::vector<double> speed = chainSpeeds(chain, points, velocity, 0.5, 1e300);
  EXPECT_NEAR(std::accumulate(speed.begin(), speed.end(), 0.0), 0.0, 1e-13);
  // The right-hand side sums to zero: the last difference closes the loop.
  double perimeter = 0.0;
  for (const double length : segmentLengths(chain, points))
  {
    perimeter += length;
  }
  const std::vector<double> still =
    chainSpeeds(chain, points, std::vector<Vec3>(7, Vec3::Zero()), 0.5, 1e300);
  const double closing = still.front() - still.back();
  EXPECT_NEAR(closing, 0.5 * (perimeter / 7.0 - segmentLengths(chain, points).back()), 1e-13);
}

TEST(LengthRedistribution, KeepsRelativeLengthsOfAShrinkingEllipse)
{
  // omega = 0: only (k . v_N)_k - mean acts. Drift of relative lengths with and without.
  const auto drift = [](double sign)
  {
    VertexChain chain;
    chain.isClosed = true;
    std::vector<Vec3> points;
    for (int k = 0; k < 100; ++k)
    {
      chain.vertices.push_back(k);
      const double angle = 0.02 * Pi * k;
      points.emplace_back(2.0 * std::cos(angle), std::sin(angle), 0.0);
    }
    const std::vector<double> start = segmentLengths(chain, points);
    for (int step = 0; step < 300; ++step)
    {
      std::vector<Vec3> curvature;
      std::vector<Vec3> tangent;
      for (Index k = 0; k < 100; ++k)
      {
        const Vec3 in = points[static_cast<std::size_t>(chain.vertex(k))] -
          points[static_cast<std::size_t>(chain.vertex(k - 1))];
        const Vec3 out = points[static_cast<std::size_t>(chain.vertex(k + 1))] -
          points[static_cast<std::size_t>(chain.vertex(k))];
        curvature.push_back((out.normalized() - in.normalized()) * 2.0 / (in.norm() + out.norm()));
        tangent.push_back((in + out).normalized());
      }
      const std::vector<double> speed = chainSpeeds(chain, points, curvature, 0.0, 1e300);
      for (std::size_t k = 0; k < 100; ++k)
      {
        points[k] += 1e-3 * (curvature[k] + sign * speed[k] * tangent[k]);
      }
    }
    const std::vector<double> end = segmentLengths(chain, points);
    const double before = std::accumulate(start.begin(), start.end(), 0.0);
    const double after = std::accumulate(end.begin(), end.end(), 0.0);
    double square = 0.0;
    for (std::size_t k = 0; k < 100; ++k)
    {
      square += std::pow(end[k] / after * before / start[k] - 1.0, 2);
    }
    return std::sqrt(square / 100.0);
  };
  EXPECT_LT(drift(1.0), 0.05 * drift(0.0));
  EXPECT_GT(drift(-1.0), drift(0.0));
}

TEST(LengthRedistribution, EvensOutTheGridOfATorus)
{
  SurfaceMesh mesh = shapes::quadTorus(16, 12, 2.0, 0.8);
  const MeshTopology topology(mesh);
  // Crowd the vertices along the ring.
  for (Vec3& p : mesh.points)
  {
    const double u = std::atan2(p.y(), p.x());
    p = Eigen::AngleAxisd(0.2 * std::sin(u), Vec3::UnitZ()) * p;
  }
  const LengthRedistribution redistribution(topology, SurfaceCurves(mesh, topology));
  const auto spreadAlongRing = [&]()
  {
    std::vector<double> lengths;
    for (Index i = 0; i < 16; ++i)
    {
      lengths.push_back((mesh.points[static_cast<std::size_t>((i + 1) % 16 * 12)] -
        mesh.points[static_cast<std::size_t>(i * 12)])
                          .norm());
    }
    return checks::relativeSpread(lengths);
  };
  const double before = spreadAlongRing();
  SurfaceGeometry geometry(topology);
  for (int step = 0; step < 40; ++step)
  {
    geometry.update(mesh, Execution());
    const std::vector<Vec3> v =
      redistribution.velocity(mesh, geometry.normals(), unmoved(mesh), 1.0, 1e300, Execution());
    for (std::size_t i = 0; i < v.size(); ++i)
    {
      EXPECT_NEAR(v[i].dot(geometry.normals()[i]), 0.0, 1e-13);
      mesh.points[i] += 0.2 * v[i];
    }
  }
  EXPECT_LT(spreadAlongRing(), 0.1 * before);
}

TEST(LengthRedistribution, LeavesVerticesWithoutChainsAlone)
{
  const SurfaceMesh mesh = icosphere(0); // valence 5 everywhere
  const MeshTopology topology(mesh);
  const LengthRedistribution redistribution(topology, SurfaceCurves(mesh, topology));
  for (const Vec3& v :
    redistribution.velocity(mesh, mesh.points, unmoved(mesh), 1.0, 1e300, Execution()))
  {
    EXPECT_EQ(v, Vec3(Vec3::Zero()));
  }
}
