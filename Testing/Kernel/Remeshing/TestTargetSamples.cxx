// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/TargetSamples.h"

#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "Trees/AABBTree.h"
#include "Trees/Barycentric.h"
#include "Trees/TriangleGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using namespace evolving;

TEST(TargetSamples, AreAsManyAsTheAreaHasSquares)
{
  for (const SurfaceMesh& mesh : { icosphere(0), icosphere(3), shapes::sheet(3, true),
         shapes::ellipsoid(2, Vec3(1.0, 0.1, 3.0)) })
  {
    for (const double spacing : { 0.5, 0.1, 0.03 })
    {
      const double expected = surfaceArea(mesh) / (spacing * spacing);
      const auto count = static_cast<double>(samplesOf(mesh, spacing).size());
      EXPECT_NEAR(count - mesh.vertexCount(), expected, 1.0);
    }
  }
}

TEST(TargetSamples, BeginWithThePoints)
{
  const SurfaceMesh mesh = icosphere(2);
  const std::vector<Vec3> samples = samplesOf(mesh, 0.1);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    EXPECT_EQ(samples[i], mesh.points[i]);
  }
}

TEST(TargetSamples, LieOnTheTriangles)
{
  const SurfaceMesh mesh = shapes::bumpySphere(2);
  const AABBTree tree(mesh);
  for (const Vec3& sample : samplesOf(mesh, 0.05))
  {
    EXPECT_LT(tree.closest(sample).at.squaredDistance, 1e-28);
  }
}

TEST(TargetSamples, AreSpreadEvenlyOverOneTriangle)
{
  // Cut into four and sixteen: each part gets its share, within two of it.
  SurfaceMesh mesh;
  mesh.points = { Vec3::Zero(), Vec3(1.0, 0.0, 0.0), Vec3(0.3, 0.8, 0.0) };
  mesh.addFace({ 0, 1, 2 });
  const std::vector<Vec3> samples = samplesOf(mesh, std::sqrt(0.4 / 400.0));
  ASSERT_EQ(samples.size(), 403U);
  std::vector<int> counts(16, 0);
  for (std::size_t i = 3; i < samples.size(); ++i)
  {
    const Vec3 weights = barycentricCoordinates(triangleOf(mesh, 0), samples[i]);
    ASSERT_GT(weights.minCoeff(), -1e-14);
    const int row = std::min(3, static_cast<int>(4.0 * weights[1]));
    const int column = std::min(3, static_cast<int>(4.0 * weights[2]));
    ++counts[static_cast<std::size_t>(4 * row + column)];
  }
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; row + column < 4; ++column)
    {
      const double share = row + column == 3 ? 25.0 : 50.0;
      EXPECT_NEAR(counts[static_cast<std::size_t>(4 * row + column)], share, 6.0);
    }
  }
}

TEST(TargetSamples, LeaveNoPlaceFar)
{
  const SurfaceMesh mesh = icosphere(1);
  const double spacing = 0.06;
  const std::vector<Vec3> samples = samplesOf(mesh, spacing);
  for (Index f = 0; f < mesh.faceCount(); ++f)
  {
    for (int i = 0; i <= 10; ++i)
    {
      for (int j = 0; i + j <= 10; ++j)
      {
        const Vec3 place = 0.1 *
          (i * mesh.facePoint(f, 0) + j * mesh.facePoint(f, 1) +
            (10 - i - j) * mesh.facePoint(f, 2));
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& sample : samples)
        {
          nearest = std::min(nearest, (sample - place).squaredNorm());
        }
        ASSERT_LT(std::sqrt(nearest), 1.7 * spacing);
      }
    }
  }
}

} // namespace
