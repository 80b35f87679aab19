// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/GaussianSmoothing.h"

#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace evolving;

namespace
{

constexpr std::array<int, 3> Size{ 14, 11, 9 };

std::vector<float> sampled(double (*function)(int, int, int))
{
  std::vector<float> values;
  for (int k = 0; k < Size[2]; ++k)
  {
    for (int j = 0; j < Size[1]; ++j)
    {
      for (int i = 0; i < Size[0]; ++i)
      {
        values.push_back(static_cast<float>(function(i, j, k)));
      }
    }
  }
  return values;
}

} // namespace

TEST(GaussianSmoothing, KeepsLinearFunctionsUpToTheEnds)
{
  const auto linear = sampled([](int i, int j, int k) { return 1.0 + 2.0 * i - 0.5 * j + k; });
  auto smoothed = linear;
  smoothGaussian(smoothed, Size, 1.5);
  for (std::size_t s = 0; s < linear.size(); ++s)
  {
    EXPECT_NEAR(smoothed[s], linear[s], 1e-4);
  }
}

TEST(GaussianSmoothing, DampsAWaveByItsGaussianFactor)
{
  // exp(-sigma^2 w^2 / 2), up to the cut at three sigma.
  const double sigma = 1.0;
  const auto wave = sampled([](int i, int, int) { return std::cos(0.8 * (i - 7)); });
  auto smoothed = wave;
  smoothGaussian(smoothed, Size, sigma);
  const std::size_t middle = 7 + Size[0] * (5 + Size[1] * 4);
  EXPECT_NEAR(smoothed[middle] / wave[middle], std::exp(-0.5 * 0.64), 0.01);
}

TEST(GaussianSmoothing, OfSigmaZeroDoesNothing)
{
  const auto values = sampled([](int i, int j, int k) { return std::sin(3.0 * i + j - k); });
  auto smoothed = values;
  smoothGaussian(smoothed, Size, 0.0);
  EXPECT_EQ(smoothed, values);
}

TEST(GaussianSmoothing, WorksOnSlicesAndWithLargeSigma)
{
  std::vector<float> slice(12, 2.5F);
  smoothGaussian(slice, { 4, 1, 3 }, 20.0);
  for (const float value : slice)
  {
    EXPECT_NEAR(value, 2.5F, 1e-5F);
  }
}

TEST(GaussianSmoothing, HasTheSameBitsForAnyNumberOfThreads)
{
  auto serial = sampled([](int i, int j, int k) { return std::sin(3.0 * i + j - k); });
  const auto values = serial;
  smoothGaussian(serial, Size, 1.2);
  for (const int threads : { 1, 2, 8 })
  {
    auto smoothed = values;
    smoothGaussian(smoothed, Size, 1.2, threadedExecution(threads, 3));
    EXPECT_EQ(smoothed, serial);
  }
}
