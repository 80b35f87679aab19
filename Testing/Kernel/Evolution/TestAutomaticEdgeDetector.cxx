// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/AutomaticEdgeDetector.h"

#include "Errors.h"
#include "Evolution/NoisyImages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace evolving;

namespace
{

double valueAt(const EdgeDetector& edges, const Vec3& p)
{
  return sampleEdgeDetector(*edges.e, p).value;
}

double largestDifference(const EdgeDetector& a, const EdgeDetector& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.e->values().size(); ++i)
  {
    largest = std::max(largest, std::abs(double(a.e->values()[i]) - b.e->values()[i]));
  }
  return largest;
}

} // namespace

TEST(AutomaticEdgeDetector, IsATenthAtEdgesAndOneOffThem)
{
  for (const double noise : { 0.0, 0.1, 0.2 })
  {
    const EdgeDetector edges =
      automaticEdgeDetector(*shapes::noisyImage(shapes::voxels(41), shapes::ballOf(10.0), noise));
    double sum = 0.0;
    for (const Vec3& direction : { Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, 1), Vec3(-0.6, 0.8, 0),
           Vec3(0, 0.6, -0.8), Vec3(0.8, 0, 0.6) })
    {
      sum += valueAt(edges, 9.9 * direction) / 6.0;
      EXPECT_GT(valueAt(edges, 14.0 * direction), 0.9);
      EXPECT_GT(valueAt(edges, 6.0 * direction), 0.9);
    }
    EXPECT_NEAR(sum, 0.1, 0.04) << noise;
  }
}

TEST(AutomaticEdgeDetector, IsFlatInNoise)
{
  const auto image = shapes::noisyImage(shapes::voxels(41), shapes::ballOf(8.0), 0.2);
  const EdgeDetector edges = automaticEdgeDetector(*image);
  int below = 0;
  int all = 0;
  for (int k = 0; k < 41; ++k)
  {
    for (int j = 0; j < 41; ++j)
    {
      for (int i = 0; i < 10; ++i, ++all)
      {
        below += edges.e->values()[static_cast<std::size_t>(image->grid().index(i, j, k))] < 1.0f;
      }
    }
  }
  // One in 100,000, were the differences at the image's border not longer.
  EXPECT_LT(below, 0.005 * all);
  // n is some 5 standard deviations of a component, 0.03 of the contrast by experiment.
  EXPECT_NEAR(edges.noise / 1060.0, 0.145, 0.03);
}

TEST(AutomaticEdgeDetector, KnowsNoUnits)
{
  const auto ball = shapes::ballOf(6.0);
  const EdgeDetector first =
    automaticEdgeDetector(*shapes::noisyImage(shapes::voxels(25), ball, 0.1));
  DistanceGrid small = shapes::voxels(25);
  small.origin *= 1e-3;
  small.spacing *= 1e-3;
  const auto smallBall = [&](const Vec3& p) { return 1e-3 * ball(1e3 * p); };
  for (const shapes::Intensities i : { shapes::Intensities{ 1e-9, 0.0 },
         shapes::Intensities{ 7.0, 8.0 }, shapes::Intensities{ -1e12, 1e12 } })
  {
    const EdgeDetector other = automaticEdgeDetector(*shapes::noisyImage(small, smallBall, 0.1, i));
    EXPECT_LT(largestDifference(first, other), 1e-3);
    const double contrast = (i.inside - i.outside) / 1060.0;
    EXPECT_NEAR(other.sharpness * contrast * contrast * 1e6 / first.sharpness, 1.0, 1e-3);
  }
}

TEST(AutomaticEdgeDetector, RefusesWhatHasNoEdges)
{
  const DistanceGrid grid = shapes::voxels(21);
  const auto nothing = [](const Vec3&) { return 100.0; };
  EXPECT_THROW(automaticEdgeDetector(*shapes::noisyImage(grid, nothing, 0.0)), InputError);
  EXPECT_THROW(automaticEdgeDetector(*shapes::noisyImage(grid, nothing, 0.1)), InputError);
  // A distance is as steep everywhere.
  EXPECT_THROW(automaticEdgeDetector(ScalarImage(grid, shapes::sampled(grid, shapes::ballOf(5.0)))),
    InputError);
}
