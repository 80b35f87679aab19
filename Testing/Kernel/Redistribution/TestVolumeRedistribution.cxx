// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/VolumeRedistribution.h"

#include "Evolution/SemiImplicitStep.h"
#include "Redistribution/CurvatureDensity.h"
#include "Redistribution/MeasuredSurface.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/MixedPolygons.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

using Surface = MeasuredSurface;

/// Mean curvature flow with v_T times `sign`; the root mean square drift of relative areas.
double driftOfRelativeAreas(double sign)
{
  Surface s(shapes::ellipsoid(3, Vec3(2.0, 1.0, 0.7)));
  const std::vector<double> start = s.geometry.coVolumes();
  const double startArea = totalArea(start, Execution());
  const std::size_t n = start.size();
  const double tau = 0.0005;
  VolumeRedistribution redistribution(s.topology);
  SemiImplicitStep step;
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
  // Triangles, mixed polygons, and a surface with boundary.
  const Surface s(shapes::merged(shapes::bumpySphere(3),
    shapes::merged(shapes::transformed(shapes::mixedSphere(2), 0.3, Vec3(5, 0, 0)),
      shapes::transformed(shapes::halfSphere(6), 1.0, Vec3(0, 5, 0)))));
  const auto components = static_cast<std::size_t>(s.topology.componentCount());
  ASSERT_EQ(components, 3u);
  for (const CurvatureControl control : { CurvatureControl::None, CurvatureControl::TwoThirds })
  {
    const std::vector<double> wanted = wantedCoVolumes(s.geometry, control, 1.0, Execution());
    const std::vector<double> b = redistributionRightHandSide(
      s.geometry, someVelocity(s.mesh), wanted, 17.0, 1e300, Execution());
    std::vector<double> sum(components, 0.0);
    std::vector<double> size(components, 0.0);
    for (std::size_t i = 0; i < b.size(); ++i)
    {
      const auto c = static_cast<std::size_t>(s.topology.componentOfVertex()[i]);
      sum[c] += b[i];
      size[c] += std::abs(b[i]);
    }
    for (std::size_t c = 0; c < components; ++c)
    {
      EXPECT_LT(std::abs(sum[c]), 1e-14 * size[c]) << "component " << c;
      EXPECT_GT(size[c], 1e-2);
    }
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
    EXPECT_LT(v.norm(), 1e-12);
  }
}

TEST(VolumeRedistribution, ComponentsDoNotKnowEachOther)
{
  const SurfaceMesh first = shapes::bumpySphere(2);
  const Surface alone(first);
  const Surface both(shapes::merged(first, shapes::transformed(first, 10.0, Vec3(50, 0, 0))));
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
