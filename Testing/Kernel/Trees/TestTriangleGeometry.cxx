// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/TriangleGeometry.h"

#include "Trees/MeasuredTriangle.h"

#include <gtest/gtest.h>

#include <random>

using namespace evolving;

namespace
{

const Triangle RightTriangle{ { Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0) } };

class RandomVectors
{
public:
  explicit RandomVectors(std::uint32_t seed)
    : Generator(seed)
  {
  }
  Vec3 operator()(double size = 1.0)
  {
    return size *
      Vec3(this->Uniform(this->Generator), this->Uniform(this->Generator),
        this->Uniform(this->Generator));
  }

private:
  std::mt19937 Generator;
  std::uniform_real_distribution<double> Uniform{ -1.0, 1.0 };
};

/// The smallest squared distance to a dense sampling of the triangle.
double sampledSquaredDistance(const Vec3& point, const Triangle& triangle, int steps)
{
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; i + j <= steps; ++j)
    {
      const double u = static_cast<double>(i) / steps;
      const double v = static_cast<double>(j) / steps;
      const Vec3 on =
        (1.0 - u - v) * triangle.corners[0] + u * triangle.corners[1] + v * triangle.corners[2];
      best = std::min(best, (point - on).squaredNorm());
    }
  }
  return best;
}

/// Random triangles: every fourth a segment, every eighth nearly one, every sixteenth a point.
Triangle randomTriangle(RandomVectors& random, int n)
{
  Triangle triangle{ { random(), random(), random() } };
  if (n % 4 == 1)
  {
    triangle.corners[2] = 0.3 * triangle.corners[0] + 0.7 * triangle.corners[1];
  }
  if (n % 8 == 2)
  {
    triangle.corners[2] = 0.3 * triangle.corners[0] + 0.7 * triangle.corners[1] + random(1e-7);
  }
  if (n % 16 == 3)
  {
    triangle.corners[2] = triangle.corners[1] = triangle.corners[0];
  }
  return triangle;
}

} // namespace

TEST(ClosestPointOnTriangle, NamesTheFeature)
{
  const auto feature = [](double x, double y)
  { return closestPointOnTriangle(Vec3(x, y, 1), RightTriangle).feature; };
  EXPECT_EQ(feature(1, 1), TriangleFeature::Face);
  EXPECT_EQ(feature(2, -1), TriangleFeature::Edge0);
  EXPECT_EQ(feature(3, 3), TriangleFeature::Edge1);
  EXPECT_EQ(feature(-1, 2), TriangleFeature::Edge2);
  EXPECT_EQ(feature(-1, -1), TriangleFeature::Vertex0);
  EXPECT_EQ(feature(6, -1), TriangleFeature::Vertex1);
  EXPECT_EQ(feature(-1, 6), TriangleFeature::Vertex2);
}

TEST(ClosestPointOnTriangle, IsNoFartherThanAnySampledPoint)
{
  RandomVectors random(7);
  for (int n = 0; n < 400; ++n)
  {
    const Triangle triangle = randomTriangle(random, n);
    const Vec3 point = random(2.0);
    const TrianglePoint closest = closestPointOnTriangle(point, triangle);
    const double sampled = sampledSquaredDistance(point, triangle, 60);
    EXPECT_LE(closest.squaredDistance, sampled + 1e-12) << n;
    // Samples are at most 1/60 of an edge away from the closest point.
    EXPECT_NEAR(std::sqrt(closest.squaredDistance), std::sqrt(sampled), 0.08) << n;
    EXPECT_NEAR((point - closest.point).squaredNorm(), closest.squaredDistance, 1e-12) << n;
    // The point lies on the triangle.
    const double off = closestPointOnTriangle(closest.point, triangle).squaredDistance;
    EXPECT_LT(std::sqrt(off), 1e-7) << n;
  }
}

TEST(ClosestPointOnTriangle, IsExactInTheFaceOfAFlatTriangle)
{
  const Triangle flat{ { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, 1e-5, 0) } };
  const TrianglePoint closest = closestPointOnTriangle(Vec3(0.5, 2e-6, 0.25), flat);
  EXPECT_EQ(closest.feature, TriangleFeature::Face);
  EXPECT_NEAR(std::sqrt(closest.squaredDistance), 0.25, 1e-9);
}

TEST(ClosestPointOnTriangle, WorksAtAnyScale)
{
  for (const double scale : { 1e-30, 1e30 })
  {
    Triangle triangle = RightTriangle;
    for (Vec3& corner : triangle.corners)
    {
      corner *= scale;
    }
    const TrianglePoint closest = closestPointOnTriangle(scale * Vec3(1, 1, 2), triangle);
    EXPECT_EQ(closest.feature, TriangleFeature::Face);
    EXPECT_NEAR(std::sqrt(closest.squaredDistance) / scale, 2.0, 1e-12);
  }
}

TEST(MeasuredTriangle, AgreesWithTheClosestPoint)
{
  RandomVectors random(11);
  for (int n = 0; n < 4000; ++n)
  {
    const Triangle triangle = randomTriangle(random, n);
    const Vec3 point = random(2.0);
    EXPECT_NEAR(std::sqrt(MeasuredTriangle<double>(triangle).squaredDistance(point)),
      std::sqrt(closestPointOnTriangle(point, triangle).squaredDistance), 2e-7)
      << n;
  }
}

TEST(TriangleBoxOverlap, AgreesWithTheClosestPointInTheBox)
{
  // Alternating projections converge to a common point of two convex sets where there is one.
  RandomVectors random(13);
  int overlapping = 0;
  for (int n = 0; n < 2000; ++n)
  {
    const Triangle triangle = randomTriangle(random, n);
    const Vec3 center = random();
    const Vec3 half = random(0.8).cwiseAbs();
    const Box box(Vec3(center - half), Vec3(center + half));
    Vec3 point = center;
    double gap = 0.0;
    for (int step = 0; step < 3000; ++step)
    {
      const Vec3 onTriangle = closestPointOnTriangle(point, triangle).point;
      point = onTriangle.cwiseMax(box.min()).cwiseMin(box.max());
      gap = (point - onTriangle).norm();
      if (gap == 0.0)
      {
        break;
      }
    }
    if (gap < 1e-12 || gap > 1e-4) // neither touching nor undecided
    {
      EXPECT_EQ(overlaps(triangle, box), gap < 1e-12) << n;
      overlapping += gap < 1e-12 ? 1 : 0;
    }
  }
  EXPECT_GT(overlapping, 200);
  EXPECT_LT(overlapping, 1800);
}

TEST(TriangleBoxOverlap, CountsTouching)
{
  const Box unit(Vec3(0, 0, 0), Vec3(1, 1, 1));
  EXPECT_TRUE(overlaps({ { Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 1, 0) } }, unit));
  EXPECT_TRUE(overlaps({ { Vec3(1, 1, 1), Vec3(1, 1, 1), Vec3(1, 1, 1) } }, unit));
  // A plane that cuts a corner's surroundings off without meeting the cube itself.
  EXPECT_FALSE(overlaps({ { Vec3(3.1, 0, 0), Vec3(0, 3.1, 0), Vec3(0, 0, 3.1) } }, unit));
  EXPECT_TRUE(overlaps({ { Vec3(2.9, 0, 0), Vec3(0, 2.9, 0), Vec3(0, 0, 2.9) } }, unit));
}
