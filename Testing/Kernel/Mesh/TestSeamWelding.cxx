// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SeamWelding.h"

#include "Mesh/TopologySummary.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Sheets.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace evolving;

namespace
{

constexpr Index Columns = 24;

/// A profile turned about the z axis, from pole to pole; the last column misses the first.
SurfaceMesh revolved(double gap)
{
  constexpr Index Rows = 8;
  SurfaceMesh mesh;
  for (Index j = 0; j <= Columns; ++j)
  {
    const double angle = 2.0 * 3.14159265358979 * (j % Columns) / Columns;
    for (Index i = 0; i < Rows; ++i)
    {
      const double z = 0.5 + i;
      const double y = std::sin(angle) + (j == Columns ? gap : 0.0);
      mesh.points.emplace_back(std::cos(angle), y, z);
    }
  }
  for (Index j = 0; j < Columns; ++j)
  {
    for (Index i = 0; i + 1 < Rows; ++i)
    {
      const Index a = j * Rows + i;
      const Index b = a + Rows;
      mesh.addFace({ a, b, b + 1 });
      mesh.addFace({ a, b + 1, a + 1 });
    }
  }
  return mesh;
}

Index openEdges(const SurfaceMesh& mesh)
{
  return summarizeTopology(mesh).boundaryEdges;
}

} // namespace

TEST(SeamWelding, ClosesASeamThatRoundingHasOpened)
{
  const SurfaceMesh open = weldCoincidentPoints(revolved(1e-9));
  ASSERT_EQ(openEdges(open), 2 * Columns + 2 * 7);
  const SurfaceMesh closed = weldSeams(open, 1e-8);
  EXPECT_EQ(openEdges(closed), 2 * Columns); // its two ends
  EXPECT_EQ(closed.faceCount(), open.faceCount());
  EXPECT_EQ(closed.vertexCount(), open.vertexCount() - 8);
}

TEST(SeamWelding, LeavesWiderGapsAndInnerPointsAlone)
{
  const SurfaceMesh open = weldCoincidentPoints(revolved(1e-6));
  EXPECT_TRUE(weldSeams(open, 1e-8) == open);
  EXPECT_TRUE(weldSeams(open, 0.0) == open);
  SurfaceMesh close = icosphere(2); // closed: nothing is a seam
  close.points[5] = close.points[6] + Vec3(1e-12, 0, 0);
  EXPECT_TRUE(weldSeams(close, 1e-8) == close);
}

TEST(SeamWelding, LeavesNeedlesAlone)
{
  SurfaceMesh needle;
  needle.points = { { 0, 0, 0 }, { 1e-9, 0, 0 }, { 0, 1, 0 } };
  needle.addFace({ 0, 1, 2 });
  EXPECT_TRUE(weldSeams(needle, 1e-8) == needle);
}

TEST(SeamWelding, ToleranceIsWhatFloatsRoundToAndNeverASize)
{
  const SurfaceMesh sphere = icosphere(3);
  const double here = roundingOf(sphere);
  EXPECT_GT(here, std::numeric_limits<float>::epsilon());
  EXPECT_LT(here, 1e-6);
  EXPECT_NEAR(roundingOf(shapes::transformed(sphere, 7.0, Vec3::Zero())), 7.0 * here, 1e-6 * here);
  // Far away doubles are as fine as here: what floats would do there is no measure.
  EXPECT_LT(roundingOf(shapes::transformed(sphere, 1.0, Vec3(1e6, 0, 0))), 1e-4);
  EXPECT_EQ(roundingOf(SurfaceMesh()), 0.0);
}
