// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * ClosestOnGrid for every number of triangles: the tree's shape depends on nothing else, and a
 * mistake in it may show at one number in eight only.
 */

#include "Distance/ClosestPoint/ClosestOnGrid.h"

#include "Distance/ClosestTriangles.h"
#include "Shapes/Draws.h"
#include "Trees/TriangleGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace evolving;

namespace
{

constexpr Index MostFaces = 700;

/// The faces of a mesh, one more at a time, against all of them.
class GrowingMesh
{
public:
  explicit GrowingMesh(const std::vector<Triangle>& triangles, const DistanceGrid& grid)
    : Triangles(triangles)
    , Grid(grid)
    , Squared(static_cast<std::size_t>(grid.sampleCount()), std::numeric_limits<double>::infinity())
  {
  }

  void addNext()
  {
    const Triangle& triangle = this->Triangles[at(this->Mesh.faceCount())];
    Index corners[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = this->Mesh.addPoint(triangle.corners[k]);
    }
    this->Mesh.addFace({ corners[0], corners[1], corners[2] });
    forEachSample(this->Grid, Execution(),
      [&](GridIndex sample, const Vec3& point)
      {
        const double squared = closestPointOnTriangle(point, triangle).squaredDistance;
        this->Squared[at(sample)] = std::min(this->Squared[at(sample)], squared);
      });
  }

  /// How many samples are told a distance that is not the smallest, or a triangle not so close.
  int wrongSamples(Instructions instructions) const
  {
    const GridClosest closest = closestOnGrid(
      this->Mesh, this->Grid, std::numeric_limits<double>::infinity(), {}, instructions);
    int wrong = 0;
    forEachSample(this->Grid, Execution(),
      [&](GridIndex sample, const Vec3& point)
      {
        const auto s = at(sample);
        const double exact = std::sqrt(this->Squared[s]);
        const Triangle& named = this->Triangles[at(closest.triangle[s])];
        const double ofNamed = std::sqrt(closestPointOnTriangle(point, named).squaredDistance);
        // Some units in the last place of floats, for shapes of the size of the grid.
        const double tolerance = 2e-6 * (1.0 + exact);
        const bool isRight =
          std::abs(static_cast<double>(closest.distance[s]) - exact) < tolerance &&
          std::abs(ofNamed - exact) < tolerance;
        wrong += isRight ? 0 : 1;
      });
    return wrong;
  }

private:
  const std::vector<Triangle>& Triangles;
  const DistanceGrid& Grid;
  SurfaceMesh Mesh;
  std::vector<double> Squared; ///< to the closest, of each sample
};

/// Where the n-th of some points lies, in a box of size 2 about the origin.
using Place = std::function<Vec3(int n)>;

struct Arrangement
{
  std::string name;
  Place place;
};

Vec3 onLattice(int n)
{
  return Vec3(n % 9, n / 9 % 9, n / 81) / 4.0 - Vec3::Ones();
}

std::vector<Arrangement> arrangements()
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Vec3> anywhere;
  for (int n = 0; n < MostFaces; ++n)
  {
    anywhere.push_back(shapes::drawnVector(uniform, random));
  }
  return {
    { "random", [anywhere](int n) { return anywhere[static_cast<std::size_t>(n)]; } },
    { "on a lattice", onLattice },
    { "in a line", [](int n) { return Vec3(Vec3(0.9, -0.7, 0.3) * (n / 350.0 - 1.0)); } },
    { "at one place", [](int) { return Vec3(0.3, -0.2, 0.1); } },
  };
}

/// A triangle with its middle about a point; of no size, a point.
Triangle triangleAt(const Vec3& place, double size, int n)
{
  const Vec3 u = Vec3(std::sin(n), std::cos(2 * n), std::sin(3 * n)) * size;
  const Vec3 v = Vec3(std::cos(5 * n), std::sin(7 * n), std::cos(n)) * size;
  return { { Vec3(place + u), Vec3(place + v), Vec3(place - u - v) } };
}

/// Every number of triangles at the places of an arrangement; every third flat where asked.
void expectRightForEveryNumber(const Arrangement& arrangement, double size, bool withSegments)
{
  std::vector<Triangle> triangles;
  for (int n = 0; n < MostFaces; ++n)
  {
    triangles.push_back(triangleAt(arrangement.place(n), size, n));
    if (withSegments && n % 3 == 0)
    {
      triangles.back().corners[2] = triangles.back().corners[0];
    }
  }
  // Bricks in the middle of the points and beside them.
  const DistanceGrid grid =
    gridAround(Box(Vec3(-1.2, -1.1, -0.9), Vec3(1.1, 1.2, 1.3)), { 6, 5, 5 }, 0.0);
  GrowingMesh mesh(triangles, grid);
  for (Index count = 1; count <= MostFaces; ++count)
  {
    mesh.addNext();
    const Instructions instructions = count % 2 == 0 ? Instructions::Any : Instructions::Best;
    ASSERT_EQ(mesh.wrongSamples(instructions), 0)
      << count << " triangles of size " << size << " " << arrangement.name;
  }
}

} // namespace

TEST(ClosestOfAnyNumber, OfPoints)
{
  for (const Arrangement& arrangement : arrangements())
  {
    expectRightForEveryNumber(arrangement, 0.0, false);
  }
}

TEST(ClosestOfAnyNumber, OfTriangles)
{
  for (const Arrangement& arrangement : arrangements())
  {
    expectRightForEveryNumber(arrangement, 0.1, false);
  }
}

TEST(ClosestOfAnyNumber, OfTrianglesAndSegmentsTooSmallToSee)
{
  for (const Arrangement& arrangement : arrangements())
  {
    expectRightForEveryNumber(arrangement, 1e-12, true);
  }
}
