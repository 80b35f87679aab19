// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceCurves.h"

#include "Evolution/EdgeChains.h"
#include "Evolution/EvolutionShapes.h"
#include "Evolution/LengthRedistribution.h"
#include "Evolution/SurfaceGeometry.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

using namespace evolving;

namespace
{

double radiusOne(double)
{
  return 1.0;
}

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

TEST(SurfaceCurves, FindsTheSidesAndCornersOfASheet)
{
  const SurfaceMesh mesh = shapes::sheet(5, true);
  const SurfaceCurves curves(mesh, MeshTopology(mesh));
  EXPECT_EQ(curves.chains().size(), 4u);
  for (const VertexChain& chain : curves.chains())
  {
    EXPECT_FALSE(chain.isClosed);
    EXPECT_EQ(chain.edgeCount(), 5);
    EXPECT_TRUE(curves.isCorner(chain.vertices.front()));
    EXPECT_TRUE(curves.isCorner(chain.vertices.back()));
  }
  EXPECT_FALSE(curves.isOnCurve(7));
  EXPECT_TRUE(curves.isOnCurve(3));
  EXPECT_FALSE(curves.isCorner(3));
}

TEST(SurfaceCurves, FindsClosedBoundaries)
{
  const SurfaceMesh mesh = shapes::tube(12, 4, 1.0, radiusOne);
  const SurfaceCurves curves(mesh, MeshTopology(mesh));
  ASSERT_EQ(curves.chains().size(), 2u);
  EXPECT_TRUE(curves.chains()[0].isClosed);
  EXPECT_EQ(curves.chains()[0].edgeCount(), 12);
}

TEST(SurfaceCurves, FindsTheCreasesOfABox)
{
  const SurfaceMesh mesh = subdividedBox(4);
  const MeshTopology topology(mesh);
  const SurfaceCurves curves(mesh, topology, 40.0);
  EXPECT_EQ(curves.chains().size(), 12u);
  int corners = 0;
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    corners += curves.isCorner(v) ? 1 : 0;
  }
  EXPECT_EQ(corners, 8);
  EXPECT_TRUE(SurfaceCurves(mesh, topology, 100.0).chains().empty());
}

TEST(SurfaceCurves, SlidingStaysOnThePolylineAndKeepsTheOrder)
{
  const SurfaceMesh mesh = shapes::tube(12, 4, 1.0, radiusOne);
  const SurfaceCurves curves(mesh, MeshTopology(mesh));
  SurfaceCurves::Positions positions = curves.startPositions();
  std::vector<Vec3> points = mesh.points;
  std::vector<Vec3> velocity;
  for (const Vec3& p : mesh.points)
  {
    velocity.push_back(Vec3(-p.y(), p.x(), 0.0) * (1.0 + 0.9 * p.x()));
  }
  for (int step = 0; step < 300; ++step) // several times round
  {
    curves.slide(velocity, 0.1, positions, points);
  }
  const double apothem = std::cos(shapes::Pi / 12.0);
  for (const VertexChain& chain : curves.chains())
  {
    double turned = 0.0;
    for (Index k = 0; k < chain.size(); ++k)
    {
      const Vec3& p = points[static_cast<std::size_t>(chain.vertex(k))];
      const Vec3& q = points[static_cast<std::size_t>(chain.vertex(k + 1))];
      EXPECT_NEAR(std::abs(p.z()), 1.0, 1e-14);
      EXPECT_LE(p.head<2>().norm(), 1.0 + 1e-12);
      EXPECT_GE(p.head<2>().norm(), apothem - 1e-12);
      turned += std::atan2(p.cross(q).z(), p.head<2>().dot(q.head<2>()));
    }
    EXPECT_NEAR(std::abs(turned), 2.0 * shapes::Pi, 1e-9); // once round, in order
  }
}

TEST(SurfaceCurves, CornersAndUnmovedVerticesKeepTheirBits)
{
  const SurfaceMesh mesh = shapes::sheet(5, true);
  const SurfaceCurves curves(mesh, MeshTopology(mesh));
  SurfaceCurves::Positions positions = curves.startPositions();
  std::vector<Vec3> points = mesh.points;
  std::vector<Vec3> velocity(points.size(), Vec3::Zero());
  velocity[0] = Vec3(1, 1, 0); // a corner
  velocity[2] = Vec3(0, 5, 3); // across its curve
  velocity[3] = Vec3(0.02, 0, 0);
  curves.slide(velocity, 1.0, positions, points);
  EXPECT_NEAR(points[3].x(), 0.62, 1e-14);
  points[3] = mesh.points[3];
  EXPECT_TRUE(points == mesh.points);
}

TEST(EdgeChains, AreTheGridLinesOfATorus)
{
  const SurfaceMesh quads = shapes::torusGrid(10, 6, 2.0, 0.7, false);
  const MeshTopology topology(quads);
  const std::vector<VertexChain> chains = edgeChains(topology, SurfaceCurves(quads, topology));
  std::map<Index, int> lengths;
  for (const VertexChain& chain : chains)
  {
    EXPECT_TRUE(chain.isClosed);
    ++lengths[chain.edgeCount()];
  }
  EXPECT_EQ(lengths, (std::map<Index, int>{ { 10, 6 }, { 6, 10 } }));
}

TEST(EdgeChains, CoverEveryInnerEdgeOnce)
{
  for (const SurfaceMesh& mesh : { icosphere(2), cubeSphere(5), shapes::sheet(6, true),
         shapes::torusGrid(9, 7, 2.0, 0.7, true) })
  {
    const MeshTopology topology(mesh);
    std::multiset<std::pair<Index, Index>> seen;
    for (const VertexChain& chain : edgeChains(topology, SurfaceCurves(mesh, topology)))
    {
      for (Index k = 0; k < chain.edgeCount(); ++k)
      {
        seen.insert(std::minmax({ chain.vertex(k), chain.vertex(k + 1) }));
      }
    }
    std::size_t inner = 0;
    for (Index corner = 0; corner < topology.cornerCount(); ++corner)
    {
      if (topology.opposite(corner) > corner)
      {
        ++inner;
        EXPECT_EQ(seen.count(std::minmax(
                    { topology.vertexOf(corner), topology.vertexOf(topology.next(corner)) })),
          1u);
      }
    }
    EXPECT_EQ(seen.size(), inner);
  }
}

TEST(EdgeChains, EndAfterTheirLongestLength)
{
  const SurfaceMesh mesh = shapes::torusGrid(12000, 3, 2.0, 0.01, false);
  const MeshTopology topology(mesh);
  std::map<Index, int> lengths;
  for (const VertexChain& chain : edgeChains(topology, SurfaceCurves(mesh, topology)))
  {
    ++lengths[chain.edgeCount()];
  }
  EXPECT_EQ(lengths, (std::map<Index, int>{ { 3, 12000 }, { LongestChain, 3 }, { 2000, 3 } }));
}

TEST(EdgeChains, EndAtIrregularVertices)
{
  const SurfaceMesh mesh = icosphere(2); // edges of the icosahedron: chains of four
  const MeshTopology topology(mesh);
  int fromIrregular = 0;
  for (const VertexChain& chain : edgeChains(topology, SurfaceCurves(mesh, topology)))
  {
    const auto isIrregular = [&](Index v) { return topology.ringCorners(v).size() == 5; };
    if (!chain.isClosed)
    {
      EXPECT_TRUE(isIrregular(chain.vertices.front()));
      EXPECT_TRUE(isIrregular(chain.vertices.back()));
      EXPECT_EQ(chain.edgeCount(), 4);
      ++fromIrregular;
    }
  }
  EXPECT_EQ(fromIrregular, 30);
}

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
      const double angle = 0.02 * shapes::Pi * k;
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
  SurfaceMesh mesh = shapes::torusGrid(16, 12, 2.0, 0.8, false);
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
    return shapes::relativeSpread(lengths);
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
