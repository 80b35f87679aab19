// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What SurfaceRedistribution makes of angles.

#include "Redistribution/SurfaceRedistribution.h"

#include "Mesh/Angles.h"
#include "Mesh/MeshQuality.h"
#include "Shapes/Sheets.h"
#include "Shapes/Slivers.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace evolving;

namespace
{

/// A square of triangles without order: valences from 4 to 8, and shaken.
SurfaceMesh irregularSheet(Index n)
{
  const SurfaceMesh quads = shapes::shakenSheet(n, false, 0.3, 11);
  SurfaceMesh mesh;
  mesh.points = quads.points;
  std::mt19937 random(12);
  for (Index face = 0; face < quads.faceCount(); ++face)
  {
    const auto corner = [&](Index k) { return quads.faceVertex(face, k % 4); };
    const Index first = random() % 2 == 0 ? 0 : 1; // which diagonal
    mesh.addFace({ corner(first), corner(first + 1), corner(first + 2) });
    mesh.addFace({ corner(first), corner(first + 2), corner(first + 3) });
  }
  return mesh;
}

/// (3.24) as the thesis has it.
SurfaceRedistributionOptions weightedEdges()
{
  SurfaceRedistributionOptions options;
  options.redistribution.angle = 3.0;
  options.redistribution.angleMethod = AngleMethod::WeightedEdges;
  return options;
}

} // namespace

TEST(RedistributionAngles, ShapeRaisesTheWorstAnglesAboveWhatWeightedEdgesReach)
{
  const SurfaceMesh input = irregularSheet(30);
  const AngleSummary before = summarizeAngles(input);
  const AngleSummary edges = summarizeAngles(redistributeSurface(input, weightedEdges()).mesh);
  const AngleSummary shape = summarizeAngles(redistributeSurface(input, {}).mesh);
  EXPECT_LT(before.firstPercentile, 16.0);
  EXPECT_GT(edges.firstPercentile, before.firstPercentile + 8.0);
  EXPECT_GT(shape.firstPercentile, edges.firstPercentile + 2.0);
  EXPECT_GT(shape.mean, 40.0);
}

TEST(RedistributionAngles, KeepsTheAnglesThatItHasGained)
{
  SurfaceMesh mesh = irregularSheet(20);
  SurfaceRedistributionOptions options;
  options.numberOfSteps = 5;
  double smallest = smallestAngle(mesh);
  const double start = smallest;
  for (int k = 0; k < 8; ++k)
  {
    mesh = redistributeSurface(mesh, options).mesh;
    EXPECT_GE(smallestAngle(mesh), smallest - 1e-9) << "after " << 5 * (k + 1) << " steps";
    smallest = smallestAngle(mesh);
  }
  EXPECT_GT(smallest, start + 5.0);
}

TEST(RedistributionAngles, VolumeAndShapeTogetherTurnNothingOver)
{
  SurfaceMesh input = irregularSheet(20);
  for (Vec3& p : input.points) // an arched roof
  {
    p.z() = 0.3 * std::sin(Pi * p.x());
  }
  SurfaceRedistributionOptions options;
  options.redistribution.volume = 1.0;
  const SurfaceMesh result = redistributeSurface(input, options).mesh;
  for (Index face = 0; face < result.faceCount(); ++face)
  {
    EXPECT_GT(faceVectorArea(result, face).z(), 0.0) << "face " << face;
  }
}

TEST(RedistributionAngles, NeverWorsensTheSmallestAngleOfOrdinaryMeshes)
{
  for (const SurfaceMesh& input : { icosphere(2), shapes::bumpySphere(3), cubeSphere(6),
         subdividedBox(5), shapes::shakenSheet(12, true, 0.45, 3),
         shapes::shakenSheet(12, false, 0.3, 4), shapes::torus(20, 10, 2.0, 0.7),
         shapes::tube(10, 6, 2.0, [](double z) { return 1.0 + 0.2 * std::sin(3.0 * z); }) })
  {
    const double before = smallestAngle(input);
    const auto result = redistributeSurface(input, SurfaceRedistributionOptions());
    EXPECT_GE(smallestAngle(result.mesh), std::min(before, 40.0) - 1e-9)
      << input.vertexCount() << " vertices";
    EXPECT_GE(summarizeAngles(result.mesh).mean, summarizeAngles(input).mean - 0.5);
  }
}

TEST(RedistributionAngles, RepairsCaps)
{
  // A vertex with three neighbours cannot do better than 30 degrees, in the middle of them.
  for (const double inwards : { 1e-5, 1e-3, 1e-2 })
  {
    for (const Index face : { 5, 100, 777 })
    {
      const SurfaceMesh input = shapes::withCap(icosphere(3), face, inwards);
      ASSERT_LT(smallestAngle(input), 120.0 * inwards);
      SurfaceRedistributionOptions options;
      EXPECT_GT(smallestAngle(redistributeSurface(input, options).mesh), 29.0) << inwards;
      options.preserveShape = false;
      EXPECT_GT(smallestAngle(redistributeSurface(input, options).mesh), 29.0) << inwards;
    }
  }
}
