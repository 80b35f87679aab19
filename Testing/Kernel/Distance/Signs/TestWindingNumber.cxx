// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/WindingNumber.h"

#include "Errors.h"
#include "Shapes/Draws.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "ThreadedExecution.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

double exactSum(const std::vector<Triangle>& triangles, const Vec3& point)
{
  double sum = 0.0;
  for (const Triangle& triangle : triangles)
  {
    sum += windingNumber(triangle, point);
  }
  return sum;
}

} // namespace

TEST(WindingNumber, OfATriangleIsItsSolidAngle)
{
  // A corner of a cube takes an eighth of the sphere.
  const Triangle octant{ { Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1) } };
  EXPECT_NEAR(windingNumber(octant, Vec3(0, 0, 0)), 0.125, 1e-14);
  const Triangle reversed{ { Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, 1, 0) } };
  EXPECT_NEAR(windingNumber(reversed, Vec3(0, 0, 0)), -0.125, 1e-14);
}

TEST(WindingNumber, IsFiniteOnTheTriangleAndForDegenerateOnes)
{
  const Triangle triangle{ { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0) } };
  for (const Vec3& point : { Vec3(0, 0, 0), Vec3(0.5, 0, 0), Vec3(0.25, 0.25, 0), Vec3(3, 0, 0) })
  {
    EXPECT_LE(std::abs(windingNumber(triangle, point)), 0.5 + 1e-12);
  }
  const Triangle segment{ { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0) } };
  EXPECT_NEAR(windingNumber(segment, Vec3(1, 1, 1)), 0.0, 1e-14);
}

TEST(WindingNumber, AgreesWithTheSumOverAllTriangles)
{
  for (const SurfaceMesh& mesh : { sphere(4), torus(60, 20, 1.0, 0.2), bowl(4, 0.2),
         randomSoup(2000, 0.2, 3), box(Vec3(-1, -1, -1), Vec3(1, 1, 1)) })
  {
    const std::vector<Triangle> triangles = trianglesOf(mesh);
    const WindingNumber winding(triangles);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.5, 1.5);
    for (int n = 0; n < 400; ++n)
    {
      const Vec3 point = shapes::drawnVector(uniform, random);
      EXPECT_NEAR(winding.at(point), exactSum(triangles, point), 0.5 * WindingNumber::Tolerance);
    }
  }
}

TEST(WindingNumber, CountsShells)
{
  const WindingNumber winding(trianglesOf(merged(sphere(3), sphere(3, 0.5))));
  EXPECT_NEAR(winding.at(Vec3(0.1, 0, 0)), 2.0, WindingNumber::Tolerance);
  EXPECT_NEAR(winding.at(Vec3(0.7, 0, 0)), 1.0, WindingNumber::Tolerance);
  EXPECT_NEAR(winding.at(Vec3(1.7, 0, 0)), 0.0, WindingNumber::Tolerance);
}

TEST(WindingNumber, OfNothingIsZero)
{
  EXPECT_EQ(WindingNumber({}).at(Vec3(1, 2, 3)), 0.0);
}

TEST(WindingNumber, IsTheSameForAnyNumberOfThreads)
{
  // Enough triangles, and an odd number of them, for parts that are built side by side.
  const std::vector<Triangle> triangles =
    trianglesOf(without(sphere(5), [](Index face) { return face % 977 == 0; }));
  const WindingNumber serial(triangles);
  const WindingNumber threaded(triangles, threadedExecution(8, 7));
  for (int i = -4; i <= 4; ++i)
  {
    const Vec3 point(0.31 * i, 0.1 + 0.07 * i, -0.2 * i);
    EXPECT_EQ(threaded.at(point), serial.at(point));
    EXPECT_NEAR(serial.at(point), exactSum(triangles, point), WindingNumber::Tolerance);
  }
}

TEST(WindingNumber, StopsWhenAsked)
{
  int questions = 0;
  const Execution stopping(nullptr, nullptr, [&] { return ++questions > 2; });
  EXPECT_THROW(WindingNumber(trianglesOf(sphere(5)), stopping), Cancelled);
}
