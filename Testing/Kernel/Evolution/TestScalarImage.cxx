// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ScalarImage.h"

#include "Errors.h"
#include "Evolution/EvolutionFields.h"
#include "Shapes/Draws.h"
#include "Shapes/SampledOnGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace evolving;

namespace
{

DistanceGrid uneven()
{
  DistanceGrid grid;
  grid.origin = Vec3(-1.0, 2.0, 0.5);
  grid.spacing = Vec3(0.5, 0.25, 1.0);
  grid.extent = { 2, 8, -3, 5, 0, 4 };
  return grid;
}

Vec3 randomPointIn(const DistanceGrid& grid, std::mt19937& random)
{
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const Vec3 low = grid.point(grid.extent[0], grid.extent[2], grid.extent[4]);
  const Vec3 high = grid.point(grid.extent[1], grid.extent[3], grid.extent[5]);
  return low + shapes::drawnVector(part, random).cwiseProduct(high - low);
}

} // namespace

TEST(ScalarImage, IsExactForLinearFunctions)
{
  const Vec3 slope(0.5, -2.0, 3.0);
  const DistanceGrid grid = uneven();
  const auto image = shapes::image(grid, [&](const Vec3& p) { return slope.dot(p) + 7.0; });
  std::mt19937 random(1);
  for (int trial = 0; trial < 200; ++trial)
  {
    const Vec3 p = randomPointIn(grid, random);
    EXPECT_NEAR(image->at(p).value, slope.dot(p) + 7.0, 1e-5); // samples are floats
    EXPECT_LT((image->at(p).gradient - slope).norm(), 1e-4);
  }
}

TEST(ScalarImage, ReproducesItsSamples)
{
  const DistanceGrid grid = uneven();
  const auto image = shapes::image(grid, [](const Vec3& p) { return std::sin(p.sum() * 3.0); });
  std::size_t n = 0;
  for (int k = 0; k <= 4; ++k)
  {
    for (int j = -3; j <= 5; ++j)
    {
      for (int i = 2; i <= 8; ++i, ++n)
      {
        EXPECT_NEAR(image->at(grid.point(i, j, k)).value, image->values()[n], 1e-12);
      }
    }
  }
}

TEST(ScalarImage, GradientsAreCentralDifferences)
{
  // x^2 has exact central differences; one-sided ones are off by the spacing.
  DistanceGrid grid = shapes::cubicGrid(5, 1.0);
  const auto image = shapes::image(grid, [](const Vec3& p) { return p.x() * p.x(); });
  EXPECT_NEAR(image->gradientAtSample(1, 2, 2).x(), -1.0, 1e-6);
  EXPECT_NEAR(image->gradientAtSample(0, 2, 2).x(), -1.5, 1e-6);
  EXPECT_NEAR(image->at(Vec3(0.25, 0.0, 0.0)).gradient.x(), 0.5, 1e-6);
}

TEST(ScalarImage, ErrorsFallWithTheSquareOfTheSpacing)
{
  double last = 0.0;
  for (const int n : { 11, 21, 41 })
  {
    const auto image = shapes::sphereField(n, 1.0, 0.5);
    std::mt19937 random(3);
    double worst = 0.0;
    for (int trial = 0; trial < 500; ++trial)
    {
      const Vec3 p = randomPointIn(image->grid(), random);
      if (p.norm() > 0.4)
      {
        worst = std::max(worst, std::abs(image->at(p).value - (p.norm() - 0.5)));
      }
    }
    EXPECT_TRUE(last == 0.0 || worst < 0.35 * last);
    last = worst;
  }
}

TEST(ScalarImage, ContinuesOutsideByTheDistance)
{
  const auto image = shapes::sphereField(21, 1.0, 0.5);
  const Vec3 beside(1.7, 0.2, -0.3); // beyond one face
  const Vec3 onFace(1.0, 0.2, -0.3);
  EXPECT_NEAR(image->at(beside).value, image->at(onFace).value + 0.7, 1e-12);
  const Vec3 inFace = image->at(onFace).gradient.cwiseProduct(Vec3(0, 1, 1));
  const Vec3 expected = (inFace + Vec3::UnitX()).normalized();
  EXPECT_LT((image->at(beside).gradient - expected).norm(), 1e-12);
  const Vec3 beyondCorner(-2.0, 3.0, -1.5);
  const Vec3 corner(-1.0, 1.0, -1.0);
  EXPECT_NEAR(
    image->at(beyondCorner).value, image->at(corner).value + (beyondCorner - corner).norm(), 1e-6);
  EXPECT_LT(
    (image->at(beyondCorner).gradient - (beyondCorner - corner).normalized()).norm(), 1e-12);
}

TEST(ScalarImage, IsContinuousAtTheBorder)
{
  const auto image = shapes::sphereField(21, 1.0, 0.5);
  for (const Vec3& p : { Vec3(1.0, 0.3, 0.2), Vec3(0.1, -1.0, 0.9), Vec3(1.0, 1.0, 0.4) })
  {
    EXPECT_NEAR(image->at(0.999999 * p).value, image->at(1.000001 * p).value, 1e-5);
  }
}

TEST(ScalarImage, IsConstantAlongAnAxisOfOneSample)
{
  DistanceGrid slice = shapes::cubicGrid(11, 1.0);
  slice.extent = { 0, 10, 0, 10, 4, 4 };
  const auto image = shapes::image(slice, [](const Vec3& p) { return p.x() + 2.0 * p.y(); });
  for (const double z : { -5.0, 0.0, 0.3, 100.0 })
  {
    EXPECT_NEAR(image->at(Vec3(0.21, 0.32, z)).value, 0.85, 1e-6);
    EXPECT_LT((image->at(Vec3(0.21, 0.32, z)).gradient - Vec3(1, 2, 0)).norm(), 1e-5);
  }
  DistanceGrid single = slice;
  single.extent = { 3, 3, 3, 3, 3, 3 };
  const ScalarImage one(single, { 4.0f });
  EXPECT_EQ(one.at(Vec3(9, 9, 9)).value, 4.0);
  EXPECT_EQ(one.at(Vec3(9, 9, 9)).gradient, Vec3(Vec3::Zero()));
}

TEST(ScalarImage, InsideBoxHoldsTheSamplesThatAreNotPositive)
{
  const Box box = shapes::sphereField(21, 1.0, 0.5)->insideBox();
  EXPECT_NEAR(box.min().x(), -0.5, 1e-6);
  EXPECT_NEAR(box.max().z(), 0.5, 1e-6);
  EXPECT_TRUE(shapes::sphereField(21, 1.0, -0.5)->insideBox().isEmpty());
}

TEST(ScalarImage, RefusesValuesThatAreNotFinite)
{
  std::vector<float> values(27, 1.0f);
  values[4] = std::numeric_limits<float>::infinity();
  values[20] = std::numeric_limits<float>::quiet_NaN();
  try
  {
    ScalarImage image(shapes::cubicGrid(3, 1.0), values);
    FAIL() << "accepted";
  }
  catch (const InputError& error)
  {
    EXPECT_EQ(std::string(error.what()).substr(0, 9), "2 of the ");
  }
}

TEST(ScalarImage, RefusesGridsThatDoNotFit)
{
  EXPECT_THROW(ScalarImage(shapes::cubicGrid(3, 1.0), std::vector<float>(26, 1.0f)), InputError);
  DistanceGrid empty;
  EXPECT_THROW(ScalarImage(empty, {}), InputError);
  DistanceGrid flat = shapes::cubicGrid(3, 1.0);
  flat.spacing.y() = 0.0;
  EXPECT_THROW(ScalarImage(flat, std::vector<float>(27, 1.0f)), InputError);
}
