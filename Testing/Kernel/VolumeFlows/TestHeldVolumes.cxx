// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "VolumeFlows/HeldVolumes.h"

#include "Errors.h"
#include "Mesh/VertexNormals.h"
#include "Operators/EnclosedVolume.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

/// Two balls and a ring, far from the origin.
SurfaceMesh threeParts()
{
  const SurfaceMesh balls =
    shapes::merged(icosphere(2), shapes::transformed(icosphere(1), 0.1, Vec3(3.0, 0.0, 0.0)));
  const SurfaceMesh ring =
    shapes::transformed(shapes::torus(16, 8, 1.0, 0.3), 1.0, Vec3(0.0, 5.0, 0.0));
  return shapes::transformed(shapes::merged(balls, ring), 1.0, Vec3(100.0, 0.0, 50.0));
}

std::vector<Vec3> normalsOf(const SurfaceMesh& mesh)
{
  return angleWeightedNormals(mesh, MeshTopology(mesh), Execution());
}

void expectVolumes(const SurfaceMesh& mesh, const std::vector<double>& expected)
{
  const std::vector<double> volumes = componentVolumes(mesh, MeshTopology(mesh));
  ASSERT_EQ(volumes.size(), expected.size());
  for (std::size_t c = 0; c < expected.size(); ++c)
  {
    EXPECT_NEAR(volumes[c], expected[c], 1e-11 * std::abs(expected[c])) << c;
  }
}

} // namespace

TEST(EnclosedVolume, IsThatOfEachComponent)
{
  const SurfaceMesh parts = threeParts();
  const std::vector<double> volumes = componentVolumes(parts, MeshTopology(parts));
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(volumes[0], signedVolume(icosphere(2)), 1e-12);
  EXPECT_NEAR(volumes[1], 1e-3 * signedVolume(icosphere(1)), 1e-15);
  EXPECT_NEAR(volumes[2], signedVolume(shapes::torus(16, 8, 1.0, 0.3)), 1e-12);
}

TEST(EnclosedVolume, HasTheGradientOfDifferences)
{
  for (const SurfaceMesh& mesh : { shapes::bumpySphere(1), shapes::shaken(cubeSphere(3), 0.1, 7) })
  {
    const std::vector<Vec3> gradient = volumeGradient(mesh);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      for (Index k = 0; k < 3; ++k)
      {
        SurfaceMesh ahead = mesh;
        SurfaceMesh behind = mesh;
        ahead.points[i][k] += 0.1; // linear in every coordinate: no error but rounding
        behind.points[i][k] -= 0.1;
        const Vec3 center = Vec3::Zero();
        EXPECT_NEAR((signedVolume(ahead, center) - signedVolume(behind, center)) / 0.2,
          gradient[i][k], 1e-13);
      }
    }
  }
}

TEST(HeldVolumes, GiveEachComponentItsVolumeBack)
{
  const SurfaceMesh start = threeParts();
  const MeshTopology topology(start);
  const HeldVolumes held(start, topology);
  SurfaceMesh moved = shapes::shaken(start, 0.02, 5);
  held.restore(moved, normalsOf(start));
  expectVolumes(moved, componentVolumes(start, topology));
}

TEST(HeldVolumes, LeaveAloneWhatIsExact)
{
  const SurfaceMesh start = threeParts();
  const MeshTopology topology(start);
  SurfaceMesh same = start;
  HeldVolumes(start, topology).restore(same, normalsOf(start));
  EXPECT_EQ(same.points, start.points);
}

TEST(HeldVolumes, SayWhenNoMultiplierDoesIt)
{
  const SurfaceMesh start = icosphere(2);
  const MeshTopology topology(start);
  const HeldVolumes held(start, topology);
  // Turned about z it can only grow, by 1 + lambda^2.
  SurfaceMesh large = start;
  std::vector<Vec3> around;
  for (Vec3& p : large.points)
  {
    p *= 2.0;
    around.emplace_back(-p.y(), p.x(), 0.0);
  }
  EXPECT_THROW(held.restore(large, around), SolverError);
}

TEST(HeldVolumes, AreHandedToNewElementsOfTheSameComponents)
{
  const SurfaceMesh parts = threeParts();
  const std::vector<double> before = componentVolumes(parts, MeshTopology(parts));
  // The other way round, and coarser.
  SurfaceMesh renewed =
    shapes::merged(shapes::transformed(shapes::torus(14, 7, 1.0, 0.3), 1.0, Vec3(0.0, 5.0, 0.0)),
      shapes::merged(shapes::transformed(icosphere(1), 0.1, Vec3(3.0, 0.0, 0.0)), icosphere(1)));
  giveBackVolumes(before, renewed, Execution());
  expectVolumes(renewed, { before[2], before[1], before[0] });
}

TEST(HeldVolumes, AreSharedByPartsThatHaveParted)
{
  const SurfaceMesh whole = shapes::transformed(icosphere(2), 1.3, Vec3::Zero());
  const double volume = signedVolume(whole);
  SurfaceMesh parts =
    shapes::merged(icosphere(2), shapes::transformed(icosphere(2), 0.9, Vec3(3.0, 0.0, 0.0)));
  giveBackVolumes({ volume }, parts, Execution());
  const double ratio = volume / (signedVolume(icosphere(2)) * (1.0 + 0.729));
  expectVolumes(
    parts, { ratio * signedVolume(icosphere(2)), 0.729 * ratio * signedVolume(icosphere(2)) });
}
