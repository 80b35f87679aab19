// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/CurvatureDensity.h"

#include "Redistribution/MeasuredSurface.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace evolving;

namespace
{

using Surface = MeasuredSurface;

} // namespace

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
