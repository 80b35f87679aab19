// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/VolumeRedistribution.h"

#include "Evolution/CurvatureDensity.h"
#include "Evolution/EvolutionShapes.h"
#include "Evolution/EvolutionStep.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace evolving;

namespace
{

struct Surface
{
  SurfaceMesh mesh;
  MeshTopology topology;
  SurfaceGeometry geometry;

  explicit Surface(const SurfaceMesh& surface)
    : mesh(surface)
    , topology(mesh)
    , geometry(topology)
  {
    this->geometry.update(this->mesh, Execution());
  }
};

/// Mean curvature flow with v_T times `sign`; the root mean square drift of relative areas.
double driftOfRelativeAreas(double sign)
{
  Surface s(shapes::ellipsoid(3, Vec3(2.0, 1.0, 0.7)));
  const std::vector<double> start = s.geometry.coVolumes();
  const double startArea = totalArea(start, Execution());
  const std::size_t n = start.size();
  const double tau = 0.0005;
  VolumeRedistribution redistribution(s.topology);
  EvolutionStep step;
  for (int k = 0; k < 200; ++k)
  {
    const std::vector<Vec3> h = s.geometry.curvatureVectors();
    std::vector<Vec3> v = redistribution.velocity(
      s.mesh, s.geometry, h, RedistributionOptions(), tau, 1e-10, Execution());
    for (Vec3& velocity : v)
    {
      velocity *= sign;
    }
    const std::vector<double> epsilon(n, 1.0);
    const std::vector<char> isKnown(n, 0);
    const std::vector<Vec3>& move =
      step.displacement(s.geometry, { epsilon, v, isKnown, v, tau }, 1e-10, Execution());
    for (std::size_t i = 0; i < n; ++i)
    {
      s.mesh.points[i] += move[i];
    }
    s.geometry.update(s.mesh, Execution());
  }
  const double area = totalArea(s.geometry.coVolumes(), Execution());
  double square = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double ratio = s.geometry.coVolumes()[i] / area * startArea / start[i];
    square += (ratio - 1.0) * (ratio - 1.0);
  }
  return std::sqrt(square / static_cast<double>(n));
}

std::vector<Vec3> someVelocity(const SurfaceMesh& mesh)
{
  std::vector<Vec3> velocity;
  for (const Vec3& p : mesh.points)
  {
    velocity.emplace_back(std::sin(p.x()), p.y() * p.z(), 1.0 - p.x());
  }
  return velocity;
}

} // namespace

TEST(VolumeRedistribution, RightHandSideSumsToZeroOverEveryComponent)
{
  const Surface s(shapes::together(shapes::bumpySphere(3),
    shapes::transformed(shapes::ellipsoid(2, Vec3(1, 2, 3)), 0.3, Vec3(5, 0, 0))));
  for (const CurvatureControl control : { CurvatureControl::None, CurvatureControl::TwoThirds })
  {
    const std::vector<double> wanted = wantedCoVolumes(s.geometry, control, 1.0, Execution());
    const std::vector<double> b = redistributionRightHandSide(
      s.geometry, someVelocity(s.mesh), wanted, 17.0, 1e300, Execution());
    const auto middle = b.begin() + 642;
    EXPECT_NEAR(std::accumulate(b.begin(), middle, 0.0), 0.0, 1e-12);
    EXPECT_NEAR(std::accumulate(middle, b.end(), 0.0), 0.0, 1e-12);
    EXPECT_GT(*std::max_element(b.begin(), b.end()), 1e-3);
  }
}

TEST(VolumeRedistribution, SatisfiesItsEquation)
{
  const Surface s(shapes::bumpySphere(3));
  RedistributionOptions options;
  options.volume = 3.0;
  VolumeRedistribution redistribution(s.topology);
  redistribution.velocity(
    s.mesh, s.geometry, someVelocity(s.mesh), options, 1e-9, 1e-12, Execution());
  const std::vector<double> wanted =
    wantedCoVolumes(s.geometry, CurvatureControl::None, 1.0, Execution());
  const std::vector<double> b =
    redistributionRightHandSide(s.geometry, someVelocity(s.mesh), wanted, 3.0, 1e9, Execution());
  std::vector<double> L;
  multiply(s.geometry.volumes().stiffness(), redistribution.potential(), L, Execution());
  EXPECT_EQ(redistribution.potential()[0], 0.0);
  for (std::size_t i = 0; i < b.size(); ++i)
  {
    EXPECT_NEAR(-L[i], b[i], 1e-9); // the pinned row too, because b sums to zero
  }
}

TEST(VolumeRedistribution, VelocityIsTangential)
{
  const Surface s(cubeSphere(8));
  RedistributionOptions options;
  options.volume = 1.0;
  VolumeRedistribution redistribution(s.topology);
  const std::vector<Vec3> v = redistribution.velocity(
    s.mesh, s.geometry, someVelocity(s.mesh), options, 1e-9, 1e-10, Execution());
  double largest = 0.0;
  for (std::size_t i = 0; i < v.size(); ++i)
  {
    EXPECT_NEAR(v[i].dot(s.geometry.normals()[i]), 0.0, 1e-13);
    largest = std::max(largest, v[i].norm());
  }
  EXPECT_GT(largest, 0.01);
}

TEST(VolumeRedistribution, KeepsRelativeAreasUnderMeanCurvatureFlow)
{
  const double without = driftOfRelativeAreas(0.0);
  const double with = driftOfRelativeAreas(1.0);
  const double wrongSign = driftOfRelativeAreas(-1.0);
  EXPECT_GT(without, 0.2);
  EXPECT_LT(with, 0.1 * without);
  EXPECT_GT(wrongSign, 1.3 * without);
}

TEST(VolumeRedistribution, DoesNotMoveARegularIcosahedron)
{
  const Surface s(icosphere(0));
  RedistributionOptions options;
  options.volume = 1.0;
  VolumeRedistribution redistribution(s.topology);
  for (const Vec3& v : redistribution.velocity(
         s.mesh, s.geometry, s.geometry.curvatureVectors(), options, 1e-9, 1e-10, Execution()))
  {
    EXPECT_LT(v.norm(), 1e-10);
  }
}

TEST(VolumeRedistribution, ComponentsDoNotKnowEachOther)
{
  const SurfaceMesh first = shapes::bumpySphere(2);
  const Surface alone(first);
  const Surface both(shapes::together(first, shapes::transformed(first, 10.0, Vec3(50, 0, 0))));
  RedistributionOptions options;
  options.volume = 2.0;
  const auto velocity = [&](const Surface& s)
  {
    return VolumeRedistribution(s.topology)
      .velocity(s.mesh, s.geometry, s.geometry.curvatureVectors(), options, 1e-9, 1e-12, {});
  };
  const std::vector<Vec3> v = velocity(alone);
  const std::vector<Vec3> w = velocity(both);
  for (std::size_t i = 0; i < v.size(); ++i)
  {
    EXPECT_LT((v[i] - w[i]).norm(), 1e-8);
  }
}

TEST(CurvatureDensity, IsUniformOnASphereAndWithoutControl)
{
  const Surface s(shapes::bumpySphere(2));
  const double mean = totalArea(s.geometry.coVolumes(), Execution()) / 162.0;
  for (const double wanted : wantedCoVolumes(s.geometry, CurvatureControl::None, 1.0, {}))
  {
    EXPECT_NEAR(wanted, mean, 1e-14);
  }
  const Surface ball(icosphere(3));
  const double meanOfBall = totalArea(ball.geometry.coVolumes(), Execution()) / 642.0;
  for (const double wanted : wantedCoVolumes(ball.geometry, CurvatureControl::TwoThirds, 1.0, {}))
  {
    EXPECT_NEAR(wanted, meanOfBall, 0.02 * meanOfBall);
  }
}

TEST(CurvatureDensity, IsSmallerWhereTheSurfaceIsCurved)
{
  const Surface s(shapes::ellipsoid(4, Vec3(2, 1, 1))); // tips at x = +-2
  const auto tip =
    static_cast<std::size_t>(std::max_element(s.mesh.points.begin(), s.mesh.points.end(),
                               [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); }) -
      s.mesh.points.begin());
  const auto side = static_cast<std::size_t>(
    std::min_element(s.mesh.points.begin(), s.mesh.points.end(),
      [](const Vec3& a, const Vec3& b) { return std::abs(a.x()) < std::abs(b.x()); }) -
    s.mesh.points.begin());
  // H = 2 a / b^2 = 4 at the tips, b / a^2 + 1 / b = 1.25 around the middle.
  const double ratio = 4.0 / 1.25;
  const auto wantedRatio = [&](CurvatureControl control, double alpha)
  {
    const std::vector<double> wanted = wantedCoVolumes(s.geometry, control, alpha, Execution());
    const double sum = std::accumulate(wanted.begin(), wanted.end(), 0.0);
    EXPECT_NEAR(sum, totalArea(s.geometry.coVolumes(), Execution()), 1e-10);
    return wanted[side] / wanted[tip];
  };
  EXPECT_NEAR(wantedRatio(CurvatureControl::CubeRoot, 1.0), std::cbrt(ratio), 0.05);
  EXPECT_NEAR(wantedRatio(CurvatureControl::TwoThirds, 1.0), std::pow(ratio, 2.0 / 3.0), 0.1);
  EXPECT_NEAR(wantedRatio(CurvatureControl::Exponential, 0.3), std::exp(0.3 * 2.75), 0.1);
}

TEST(CurvatureDensity, DiffersByTenToOneAtMost)
{
  const Surface s(subdividedBox(8)); // flat sides, sharp edges
  for (const CurvatureControl control :
    { CurvatureControl::CubeRoot, CurvatureControl::TwoThirds, CurvatureControl::Exponential })
  {
    const std::vector<double> wanted = wantedCoVolumes(s.geometry, control, 1e3, Execution());
    const auto ends = std::minmax_element(wanted.begin(), wanted.end());
    EXPECT_GT(*ends.first, 0.0);
    EXPECT_LE(*ends.second / *ends.first, LargestAreaRatio * (1.0 + 1e-12));
    EXPECT_GT(*ends.second / *ends.first, 3.0);
  }
}

TEST(CurvatureDensity, IsUniformOnAPlane)
{
  const Surface s(shapes::sheet(6, true));
  // The pull at the boundary is along the plane: H = 0 everywhere.
  for (const double wanted : wantedCoVolumes(s.geometry, CurvatureControl::TwoThirds, 1.0, {}))
  {
    EXPECT_NEAR(wanted, 1.0 / 49.0, 1e-12);
  }
}
