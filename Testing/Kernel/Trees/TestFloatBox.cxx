// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/FloatBox.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using namespace evolving;

void expectSmallestAround(double low, double high)
{
  const FloatBox box = roundedOutwards(Box(Vec3::Constant(low), Vec3::Constant(high)));
  for (int axis = 0; axis < 3; ++axis)
  {
    const float below = box.min()[axis];
    const float above = box.max()[axis];
    EXPECT_LE(static_cast<double>(below), low);
    EXPECT_GE(static_cast<double>(above), high);
    EXPECT_GT(static_cast<double>(std::nextafter(below, HUGE_VALF)), low);
    EXPECT_LT(static_cast<double>(std::nextafter(above, -HUGE_VALF)), high);
  }
}

TEST(FloatBox, IsTheSmallestAroundADoubleBox)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> decade(-50.0, 45.0);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int n = 0; n < 10000; ++n)
  {
    const double low = uniform(random) * std::pow(10.0, decade(random));
    expectSmallestAround(low, low + std::abs(uniform(random)) * std::pow(10.0, decade(random)));
  }
}

TEST(FloatBox, OfFloatsIsTheSame)
{
  expectSmallestAround(0.0, 0.0);
  expectSmallestAround(-0.125, 1e6);
  const FloatBox box = roundedOutwards(Box(Vec3(-0.5, 1e6, 0.0), Vec3(0.25, 1e6, 3.0)));
  EXPECT_EQ(box.min(), Eigen::Vector3f(-0.5F, 1e6F, 0.0F));
  EXPECT_EQ(box.max(), Eigen::Vector3f(0.25F, 1e6F, 3.0F));
}

} // namespace
