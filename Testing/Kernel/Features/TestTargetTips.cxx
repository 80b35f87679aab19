// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/TargetTips.h"

#include "Mesh/Angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace evolving;

namespace
{

/// A cone of some sides, its apex first; around that there are as many degrees as in a sector.
SurfaceMesh cone(Index sides, double degrees, bool isClosed = true)
{
  SurfaceMesh mesh;
  const double step = 2.0 * Pi / sides;
  const double slant = std::sin(0.5 * step) / std::sin(0.5 * degrees / sides * RadiansPerDegree);
  mesh.addPoint(Vec3(0, 0, std::sqrt(slant * slant - 1.0)));
  const Index middle = mesh.addPoint(Vec3::Zero());
  for (Index k = 0; k < sides; ++k)
  {
    mesh.addPoint(Vec3(std::cos(k * step), std::sin(k * step), 0.0));
  }
  for (Index k = 0; k < sides; ++k)
  {
    const Index a = 2 + k;
    const Index b = 2 + (k + 1) % sides;
    if (isClosed || k > 0)
    {
      mesh.addFace({ 0, a, b });
    }
    mesh.addFace({ middle, b, a });
  }
  return mesh;
}

std::vector<Index> tips(const SurfaceMesh& mesh)
{
  return tipsOf(TargetTriangles(mesh));
}

} // namespace

TEST(TargetTips, AreMorePointedThanATetrahedron)
{
  for (const Index sides : { 4, 6, 40 })
  {
    EXPECT_EQ(tips(cone(sides, 178.0)).size(), 1U) << sides;
    EXPECT_EQ(tips(cone(sides, 182.0)).size(), 0U) << sides;
  }
}

TEST(TargetTips, HaveFacesAllAround)
{
  EXPECT_EQ(tips(cone(6, 150.0)).size(), 1U);
  EXPECT_EQ(tips(cone(6, 150.0, false)).size(), 0U);
}
