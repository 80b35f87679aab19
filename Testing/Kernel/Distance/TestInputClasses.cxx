// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Inputs as users' files have them: whatever the surface, the distance is that to the nearest of
// its triangles. Which side is inside is asked in Testing/Cxx/TestMeshSDFSignTable.cxx.

#include "Distance/ClosestTriangles.h"
#include "Distance/SignedDistance.h"
#include "Errors.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "Trees/TriangleGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

SurfaceMesh withUnreferencedPoints()
{
  SurfaceMesh mesh = sphere(2);
  mesh.points.insert(mesh.points.begin() + 3, Vec3(NaN, 50.0, 0.0));
  for (Index& vertex : mesh.cornerVertices)
  {
    vertex += vertex >= 3 ? 1 : 0;
  }
  mesh.addPoint(Vec3(0.2, 0.1, 0.0));
  return mesh;
}

SurfaceMesh square()
{
  SurfaceMesh mesh;
  mesh.points = { Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0) };
  mesh.addFace({ 0, 1, 2 });
  mesh.addFace({ 0, 2, 3 });
  return mesh;
}

/// The distance by the definition. A face that uses a point twice is not part of the surface.
double distanceToProperFaces(const SurfaceMesh& mesh, const Vec3& point)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const Triangle triangle{ { mesh.facePoint(face, 0), mesh.facePoint(face, 1),
      mesh.facePoint(face, 2) } };
    const auto& [a, b, c] = triangle.corners;
    if (a != b && b != c && c != a)
    {
      smallest = std::min(smallest, closestPointOnTriangle(point, triangle).squaredDistance);
    }
  }
  return std::sqrt(smallest);
}

/// What the documentation of the methods allows, in cells.
double slackOf(DistanceMethod method)
{
  switch (method)
  {
    case DistanceMethod::BruteForce:
      return 1e-5;
    case DistanceMethod::ClosestPoint:
      return 1e-4;
    case DistanceMethod::FastSweeping:
      break;
  }
  return 2.5;
}

void expectDistances(const SurfaceMesh& mesh, const DistanceGrid& grid)
{
  for (const DistanceMethod method :
    { DistanceMethod::ClosestPoint, DistanceMethod::FastSweeping, DistanceMethod::BruteForce })
  {
    SignedDistanceOptions options;
    options.method = method;
    const auto result = signedDistance(mesh, grid, grid.extent, options);
    double worst = 0.0;
    forEachSample(grid, Execution(),
      [&](GridIndex sample, const Vec3& point)
      {
        const double distance = result.distance[static_cast<std::size_t>(sample)];
        ASSERT_TRUE(std::isfinite(distance));
        worst = std::max(worst, std::abs(std::abs(distance) - distanceToProperFaces(mesh, point)));
      });
    EXPECT_LE(worst, slackOf(method) * grid.spacing.x())
      << "method " << static_cast<int>(method) << " on " << grid.dimension(0) << " x "
      << grid.dimension(1) << " x " << grid.dimension(2) << ", in cells "
      << worst / grid.spacing.x();
  }
}

struct InputClass
{
  const char* name;
  SurfaceMesh (*make)();
};

const InputClass Classes[] = {
  { "OneTriangle",
    [] { return triangleMesh(Vec3(-1, -1, 0), Vec3(1, -1, 0.2), Vec3(0, 1, 0.1)); } },
  { "TwoOppositeTriangles",
    []
    {
      const SurfaceMesh one = triangleMesh(Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0));
      return merged(one, reversed(one));
    } },
  { "CollinearTriangle",
    [] { return triangleMesh(Vec3(-1, 0, 0), Vec3(1, 0.5, 0), Vec3(0, 0.25, 0)); } },
  { "ZeroAreaBesideASphere",
    [] {
      return merged(sphere(2), triangleMesh(Vec3(-1, -1, 1), Vec3(1, -1, 1), Vec3(0.3, -1, 1)));
    } },
  { "Planar", square }, { "Unreferenced", withUnreferencedPoints },
  { "RepeatedFaces", [] { return merged(sphere(2), merged(sphere(2), reversed(sphere(2)))); } },
  { "Flipped", [] { return reversed(sphere(2)); } },
  { "MixedOrientation",
    [] { return turned(sphere(2), [](Index face) { return face % 3 == 0; }); } },
  { "Open", [] { return bowl(3, 0.2); } },
  { "SeveralComponents", [] { return merged(sphere(2), sphere(2, 0.5, Vec3(2, 0.3, 0))); } },
  { "NestedShells", [] { return merged(sphere(2), sphere(2, 0.5)); } },
  { "NonManifoldEdge",
    []
    { return merged(box(Vec3(-1, -1, -1), Vec3(0, 0, 0)), box(Vec3(0, 0, -1), Vec3(1, 1, 0))); } },
  { "NonManifoldVertex",
    []
    { return merged(box(Vec3(-1, -1, -1), Vec3(0, 0, 0)), box(Vec3(0, 0, 0), Vec3(1, 1, 1))); } },
  { "SelfIntersecting", [] { return torus(24, 16, 0.5, 0.8); } },
  { "Moebius", [] { return fanned(moebiusBand(30, 1.0, 0.4)); } },
  { "Klein", [] { return kleinBottle(30, 16); } },
  { "FarAway", [] { return sphere(2, 1.0, Vec3(1e6, -1e6, 1e6)); } },
  { "Soup", [] { return randomSoup(60, 0.5, 3); } }
};

std::string nameOf(const testing::TestParamInfo<InputClass>& tested)
{
  return tested.param.name;
}

class InputClasses : public testing::TestWithParam<InputClass>
{
};

} // namespace

TEST_P(InputClasses, DistanceIsThatToTheNearestTriangle)
{
  const SurfaceMesh mesh = GetParam().make();
  expectDistances(mesh, gridAround(boundingBox(mesh), { 13, 12, 14 }, 0.2));
}

TEST_P(InputClasses, AlsoOnASliceALineAndASinglePoint)
{
  const SurfaceMesh mesh = GetParam().make();
  using Size = std::array<int, 3>;
  for (const Size& size : { Size{ 13, 13, 1 }, Size{ 1, 13, 13 }, Size{ 13, 1, 13 },
         Size{ 13, 1, 1 }, Size{ 1, 13, 1 }, Size{ 1, 1, 13 }, Size{ 1, 1, 1 } })
  {
    expectDistances(mesh, gridAround(boundingBox(mesh), size, 0.1));
  }
}

INSTANTIATE_TEST_SUITE_P(All, InputClasses, testing::ValuesIn(Classes), nameOf);

TEST(InputClassesOfSize, FloatsHoldAreComputedAndOthersRefused)
{
  for (const double scale : { 1e-30, 1e-31, 1e30 })
  {
    SurfaceMesh mesh = sphere(1, scale);
    expectDistances(mesh, gridAround(boundingBox(mesh), { 5, 5, 5 }, 0.1));
  }
  for (const double scale : { 1e-32, 1e-100, 1e-300, 1e32, 1e39, 1e100, 1e300 })
  {
    const SurfaceMesh mesh = sphere(1, scale);
    const DistanceGrid grid = gridAround(boundingBox(mesh), { 5, 5, 5 }, 0.1);
    EXPECT_THROW(signedDistance(mesh, grid, grid.extent, {}), InputError) << scale;
  }
}
