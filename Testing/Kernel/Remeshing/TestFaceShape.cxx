// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/FaceShape.h"

#include "Shapes/Draws.h"
#include "Shapes/MeshVariants.h"
#include "Trees/Barycentric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using namespace evolving;

using namespace evolving::shapes;

double angleAt(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return std::atan2((b - a).cross(c - a).norm(), (b - a).dot(c - a));
}

TEST(FaceShape, IsOneForEquilateralTriangles)
{
  const Vec3 a = Vec3::UnitX();
  const Vec3 b = Vec3::UnitY();
  const Vec3 c = Vec3::UnitZ();
  EXPECT_NEAR(faceShape(a, b, c), 1.0, 1e-15);
  EXPECT_NEAR(cosineOfSmallestAngle(a, b, c), 0.5, 1e-15);
}

TEST(FaceShape, OfARightTriangleByHand)
{
  // Sides 3, 4, 5: area 6, squares 50, smallest angle atan(3/4).
  const Vec3 a = Vec3::Zero();
  const Vec3 b(3.0, 0.0, 0.0);
  const Vec3 c(0.0, 4.0, 0.0);
  EXPECT_NEAR(faceShape(a, b, c), 24.0 * std::sqrt(3.0) / 50.0, 1e-15);
  EXPECT_NEAR(cosineOfSmallestAngle(a, b, c), 0.8, 1e-15);
}

TEST(FaceShape, OfAFaceIsThatOfItsCorners)
{
  SurfaceMesh mesh;
  mesh.points = { Vec3::Zero(), Vec3(3.0, 0.0, 0.0), Vec3(0.0, 4.0, 0.0), Vec3(-3.0, 0.0, 0.0) };
  mesh.addFace({ 0, 1, 2 });
  mesh.addFace({ 0, 2, 3 });
  const EditableSurface surface(mesh);
  for (Index face = 0; face < 2; ++face)
  {
    EXPECT_NEAR(cosineOfSmallestAngle(surface, face), 0.8, 1e-15);
    EXPECT_NEAR(smallestAngle(surface, face), 36.869897645844, 1e-9);
  }
}

TEST(FaceShape, IsWorstWithoutArea)
{
  const Vec3 a(1.0, 2.0, 3.0);
  const Vec3 b(2.0, 4.0, 6.0);
  EXPECT_EQ(faceShape(a, a, a), 0.0);
  EXPECT_EQ(faceShape(a, a, b), 0.0);
  EXPECT_EQ(faceShape(a, b, 2.0 * b), 0.0);
  EXPECT_EQ(cosineOfSmallestAngle(a, a, a), 1.0);
  EXPECT_EQ(cosineOfSmallestAngle(a, b, b), 1.0);
  EXPECT_NEAR(cosineOfSmallestAngle(a, b, 2.0 * b), 1.0, 1e-15);
}

TEST(FaceShape, AgreesWithTheAngles)
{
  std::mt19937 generator(1);
  for (int i = 0; i < 1000; ++i)
  {
    const Vec3 a = randomPoint(generator);
    const Vec3 b = randomPoint(generator);
    const Vec3 c = randomPoint(generator);
    const double alpha = angleAt(a, b, c);
    const double beta = angleAt(b, c, a);
    const double gamma = angleAt(c, a, b);
    EXPECT_NEAR(cosineOfSmallestAngle(a, b, c), std::cos(std::min({ alpha, beta, gamma })), 1e-12);
    // The sum of squares is 4 area times the sum of the cotangents.
    const double cotangents = 1.0 / std::tan(alpha) + 1.0 / std::tan(beta) + 1.0 / std::tan(gamma);
    EXPECT_NEAR(faceShape(a, b, c), std::sqrt(3.0) / cotangents, 1e-10);
    EXPECT_NEAR(faceShape(b, c, a), faceShape(a, b, c), 1e-14);
    EXPECT_EQ(faceShape(4.0 * a, 4.0 * b, 4.0 * c), faceShape(a, b, c));
  }
}

TEST(Barycentric, WeightsGiveThePointBack)
{
  std::mt19937 generator(2);
  for (int i = 0; i < 1000; ++i)
  {
    const Triangle triangle = { { randomPoint(generator), randomPoint(generator),
      randomPoint(generator) } };
    const Vec3 weights(0.2, 1.1, -0.3);
    const Vec3 point =
      0.2 * triangle.corners[0] + 1.1 * triangle.corners[1] - 0.3 * triangle.corners[2];
    const Vec3 normal = triangle.doubleAreaNormal();
    const double accuracy = 1e-14 / normal.squaredNorm();
    EXPECT_LT((barycentricCoordinates(triangle, point) - weights).norm(), accuracy);
    // What lies beside the plane does not matter.
    EXPECT_LT((barycentricCoordinates(triangle, point + normal) - weights).norm(), accuracy);
  }
}

TEST(FaceShape, CosinesAreComparedAsIfTheyWereComputed)
{
  std::mt19937 random(13);
  std::normal_distribution<double> normal;
  const auto somewhere = [&] { return shapes::drawnVector(normal, random); };
  for (const double scale : { 1e-80, 1e-20, 1.0, 1e20 })
  {
    for (int n = 0; n < 500; ++n)
    {
      const Vec3 a = scale * somewhere();
      const Vec3 b = scale * somewhere();
      const Vec3 c = n % 5 == 0 ? b : Vec3(scale * somewhere()); // some without area
      const double cosine = cosineOfSmallestAngle(a, b, c);
      const double others = cosineOfSmallestAngle(b, scale * somewhere(), c);
      for (const double limit : { cosine, std::nextafter(cosine, 0.0), std::nextafter(cosine, 2.0),
             (1.0 + 1e-13) * cosine, (1.0 + 1e-11) * cosine, others, 0.0, -1.0 })
      {
        ASSERT_EQ(hasSmallerCosine(a, b, c, limit), cosine < limit)
          << "scale " << scale << ", cosine " << cosine << ", limit " << limit;
      }
    }
  }
}

} // namespace
