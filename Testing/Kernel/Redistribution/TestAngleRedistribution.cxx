// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/AngleRedistribution.h"

#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Redistribution/MeasuredSurface.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

struct Surface : MeasuredSurface
{
  using MeasuredSurface::MeasuredSurface;

  std::vector<Vec3> velocity(const RedistributionOptions& options, double timeStep,
    const std::vector<double>& distance = {}, double scale = 1.0) const
  {
    const std::vector<Vec3> noCurves(this->mesh.points.size(), Vec3::Zero());
    return angleRedistribution(
      this->mesh, this->geometry, noCurves, options, distance, scale, timeStep, Execution());
  }
};

RedistributionOptions rate(double angle, AngleWeighting weighting = AngleWeighting::None)
{
  RedistributionOptions options;
  options.angle = angle;
  options.angleWeighting = weighting;
  return options;
}

/// A hexagon of unit edges around vertex 0.
SurfaceMesh hexagon()
{
  SurfaceMesh mesh;
  mesh.addPoint(Vec3::Zero());
  for (int k = 0; k < 6; ++k)
  {
    mesh.addPoint(Vec3(std::cos(k * Pi / 3.0), std::sin(k * Pi / 3.0), 0.0));
  }
  for (Index k = 0; k < 6; ++k)
  {
    mesh.addFace({ 0, 1 + k, 1 + (k + 1) % 6 });
  }
  return mesh;
}

} // namespace

TEST(AngleRedistribution, RestsInARegularRing)
{
  const Surface s(hexagon());
  EXPECT_LT(angleVelocity(s.mesh, s.topology, 0, 1.0).norm(), 1e-14);
}

TEST(AngleRedistribution, IsThreeTimesTheUmbrellaForSmallMovesAtValenceSix)
{
  // (3.24) by hand: 1 + cos 60 = 3/2, and every edge is in two pairs.
  SurfaceMesh mesh = hexagon();
  const Vec3 move(1e-6, 2e-6, 0.0);
  mesh.points[0] += move;
  const Surface s(mesh);
  Vec3 exact = Vec3::Zero();
  for (std::size_t k = 1; k <= 6; ++k)
  {
    const Vec3 a = mesh.points[k] - mesh.points[0];
    const Vec3 b = mesh.points[k % 6 + 1] - mesh.points[0];
    exact += (1.0 + a.dot(b) / (a.norm() * b.norm())) * (a + b) * 0.7 / 6.0;
  }
  const Vec3 v = angleVelocity(s.mesh, s.topology, 0, 0.7);
  EXPECT_LT((v - exact).norm(), 1e-15);
  EXPECT_LT((v + 3.0 * 0.7 * move).norm(), 0.5 * v.norm()); // the angles change as well
  EXPECT_LT(v.dot(move), 0.0);
}

TEST(AngleRedistribution, CountsOnlyPairsInsideAtTheBoundary)
{
  const Surface s(hexagon());
  // Boundary vertex 1 at (1, 0): edges to vertices 2, 0, 6 with two pairs of 60 degrees.
  const Vec3 e2 = s.mesh.points[2] - s.mesh.points[1];
  const Vec3 e0 = s.mesh.points[0] - s.mesh.points[1];
  const Vec3 e6 = s.mesh.points[6] - s.mesh.points[1];
  const Vec3 expected = 1.5 / 3.0 * ((e2 + e0) + (e0 + e6));
  EXPECT_LT((angleVelocity(s.mesh, s.topology, 1, 1.0) - expected).norm(), 1e-14);
}

TEST(AngleRedistribution, IsTangential)
{
  const Surface s(shapes::bumpySphere(3));
  const std::vector<Vec3> v = s.velocity(rate(1.0), 0.01);
  for (std::size_t i = 0; i < v.size(); ++i)
  {
    EXPECT_NEAR(v[i].dot(s.geometry.normals()[i]), 0.0, 1e-14);
  }
}

TEST(AngleRedistribution, IsLimitedToAQuarterOfTheSmallestAltitude)
{
  const Surface s(shapes::shakenSheet(10, true, 0.45, 4));
  const std::vector<Vec3> v = s.velocity(rate(1e6), 0.01);
  for (Index i = 0; i < s.mesh.vertexCount(); ++i)
  {
    const double altitude = smallestAltitude(s.mesh, s.topology, i);
    EXPECT_LE(0.01 * v[static_cast<std::size_t>(i)].norm(), 0.25 * altitude * (1.0 + 1e-12));
  }
  EXPECT_NEAR(smallestAltitude(hexagon(), Surface(hexagon()).topology, 0), std::sqrt(0.75), 1e-14);
}

TEST(AngleRedistribution, ImprovesTheAnglesOfAShakenSheet)
{
  Surface s(shapes::shakenSheet(10, true, 0.4, 6));
  const double before = summarizeAngles(s.mesh).mean;
  for (int step = 0; step < 50; ++step)
  {
    const std::vector<Vec3> v = s.velocity(rate(1.0), 0.1);
    for (Index i = 0; i < s.mesh.vertexCount(); ++i)
    {
      const auto k = static_cast<std::size_t>(i);
      s.mesh.points[k] += s.topology.isBoundary(i) ? Vec3(Vec3::Zero()) : Vec3(0.1 * v[k]);
    }
    s.geometry.update(s.mesh, Execution());
  }
  EXPECT_GT(summarizeAngles(s.mesh).mean, before + 7.0);
}

TEST(AngleRedistribution, WeightsFollowSection62)
{
  const Surface s(shapes::shakenSheet(8, true, 0.4, 7));
  const std::vector<Vec3> plain = s.velocity(rate(1e-3), 1e-3);
  const std::vector<Vec3> byArea = s.velocity(rate(1e-3, AngleWeighting::InverseArea), 1e-3);
  const std::vector<double> distance(plain.size(), -0.25);
  const std::vector<Vec3> byDistance =
    s.velocity(rate(1e-3, AngleWeighting::Distance), 1e-3, distance, 2.0);
  const std::vector<Vec3> withoutDistance = s.velocity(rate(1e-3, AngleWeighting::Distance), 1e-3);
  const double mean = 1.0 / 81.0;
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    const double factor = std::min(1.0, mean / s.geometry.coVolumes()[i]);
    EXPECT_LT((byArea[i] - factor * plain[i]).norm(), 1e-15);
    EXPECT_LT((byDistance[i] - 0.125 * plain[i]).norm(), 1e-15);
    EXPECT_EQ(withoutDistance[i], plain[i]);
  }
}
