// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Sweeping/FastSweeping.h"

#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace evolving;

namespace
{

/// Freezes the samples for which `isFrozen` at the exact distance.
SweptField frozenField(const std::array<int, 3>& dimensions,
  const std::function<double(const Vec3&)>& distance,
  const std::function<bool(const Vec3&)>& isFrozen)
{
  SweptField field(dimensions);
  for (int k = 0; k < dimensions[2]; ++k)
  {
    for (int j = 0; j < dimensions[1]; ++j)
    {
      for (int i = 0; i < dimensions[0]; ++i)
      {
        if (isFrozen(Vec3(i, j, k)))
        {
          field.freeze(field.index(i, j, k), static_cast<float>(distance(Vec3(i, j, k))));
        }
      }
    }
  }
  return field;
}

/// Outside a sphere of n / 4 cells in the middle of n^3 samples.
SweptField sphereField(int n)
{
  const Vec3 center = Vec3::Constant(0.5 * (n - 1));
  const double radius = 0.25 * n;
  const auto distance = [=](const Vec3& p) { return std::abs((p - center).norm() - radius); };
  return frozenField({ n, n, n }, distance, [=](const Vec3& p) { return distance(p) < 1.0; });
}

/// The root mean square error of the swept sphere, relative to its radius.
double sphereError(int n)
{
  SweptField field = sphereField(n);
  sweep(field, 8);
  const Vec3 center = Vec3::Constant(0.5 * (n - 1));
  double sum = 0.0;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const double exact = std::abs((Vec3(i, j, k) - center).norm() - 0.25 * n);
        const auto swept =
          static_cast<double>(field.distance[static_cast<std::size_t>(field.index(i, j, k))]);
        sum += (swept - exact) * (swept - exact);
      }
    }
  }
  return std::sqrt(sum / (double(n) * n * n)) / (0.25 * n);
}

} // namespace

TEST(GodunovSolution, SolvesTheUpwindEquationWithTheFewestTerms)
{
  EXPECT_FLOAT_EQ(godunovSolution(2.0F, 5.0F, 9.0F), 3.0F);
  EXPECT_FLOAT_EQ(godunovSolution(2.0F, 2.0F, 9.0F), 2.0F + std::sqrt(0.5F));
  EXPECT_FLOAT_EQ(godunovSolution(2.0F, 2.0F, 2.0F), 2.0F + std::sqrt(1.0F / 3.0F));
  for (const float a2 : { 0.0F, 0.3F, 0.7F, 0.99F, 1.5F })
  {
    for (const float a3 : { a2, a2 + 0.1F, a2 + 0.5F, a2 + 2.0F })
    {
      const float x = godunovSolution(0.0F, a2, a3);
      const auto term = [x](float a) { return std::pow(std::max(x - a, 0.0F), 2.0F); };
      EXPECT_NEAR(term(0.0F) + term(a2) + term(a3), 1.0F, 1e-5F) << a2 << " " << a3;
    }
  }
}

TEST(GodunovSolution, LosesNothingFarFromTheSurface)
{
  const float far = 4096.0F;
  EXPECT_NEAR(
    godunovSolution(far, far + 0.25F, far + 0.5F) - far, godunovSolution(0.0F, 0.25F, 0.5F), 5e-4F);
}

TEST(FastSweeping, IsExactForAPlane)
{
  SweptField field = frozenField(
    { 9, 12, 20 }, [](const Vec3& p) { return std::abs(p.z() - 7.25); },
    [](const Vec3& p) { return std::abs(p.z() - 7.25) < 1.0; });
  sweep(field, 8);
  for (int k = 0; k < 20; ++k)
  {
    for (int j = 0; j < 12; ++j)
    {
      for (int i = 0; i < 9; ++i)
      {
        EXPECT_NEAR(
          field.distance[static_cast<std::size_t>(field.index(i, j, k))], std::abs(k - 7.25), 1e-5);
      }
    }
  }
}

TEST(FastSweeping, IsOfFirstOrderForASphere)
{
  const double coarse = sphereError(48);
  const double fine = sphereError(96);
  const double slope = std::log2(coarse / fine);
  EXPECT_GE(slope, 0.9);
  EXPECT_LE(slope, 1.6);
  EXPECT_LT(fine, 0.05);
}

TEST(FastSweeping, HasSlopeOneAwayFromTheSurface)
{
  // The upwind differences, not the central ones, are what the scheme solves.
  const int n = 32;
  SweptField field = sphereField(n);
  sweep(field, 8);
  const auto at = [&](int i, int j, int k)
  { return static_cast<double>(field.distance[static_cast<std::size_t>(field.index(i, j, k))]); };
  for (int k = 1; k + 1 < n; ++k)
  {
    for (int j = 1; j + 1 < n; ++j)
    {
      for (int i = 1; i + 1 < n; ++i)
      {
        if (field.frozen[static_cast<std::size_t>(field.index(i, j, k))])
        {
          continue;
        }
        const auto upwind = [&](double a, double b)
        { return std::pow(std::max(at(i, j, k) - std::min(a, b), 0.0), 2.0); };
        const double slope = upwind(at(i - 1, j, k), at(i + 1, j, k)) +
          upwind(at(i, j - 1, k), at(i, j + 1, k)) + upwind(at(i, j, k - 1), at(i, j, k + 1));
        EXPECT_NEAR(slope, 1.0, 1e-3);
      }
    }
  }
}

TEST(FastSweeping, EightSweepsFromACornerReachEverySample)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    SweptField field({ 7, 6, 5 });
    field.freeze(field.index((corner & 1) * 6, (corner >> 1 & 1) * 5, (corner >> 2) * 4), 0.0F);
    sweep(field, 8);
    for (const float distance : field.distance)
    {
      EXPECT_LT(distance, 20.0F);
    }
  }
}

TEST(FastSweeping, MoreSweepsNeverRaiseADistance)
{
  SweptField field = sphereField(20);
  sweep(field, 1);
  for (int sweeps = 2; sweeps <= 12; ++sweeps)
  {
    SweptField more = sphereField(20);
    sweep(more, sweeps);
    for (std::size_t s = 0; s < field.distance.size(); ++s)
    {
      ASSERT_LE(more.distance[s], field.distance[s]);
    }
    field = more;
  }
}

TEST(FastSweeping, WorksOnSlicesAndLines)
{
  SweptField line = frozenField(
    { 1, 1, 9 }, [](const Vec3&) { return 0.0; }, [](const Vec3& p) { return p.z() == 4.0; });
  sweep(line, 8);
  EXPECT_FLOAT_EQ(line.distance.front(), 4.0F);
  EXPECT_FLOAT_EQ(line.distance.back(), 4.0F);
}

TEST(FastSweeping, LeavesFrozenSamplesAlone)
{
  SweptField field({ 5, 1, 1 });
  field.freeze(0, 0.0F);
  field.freeze(3, 7.0F);
  sweep(field, 8);
  EXPECT_EQ(field.distance[3], 7.0F);
  EXPECT_EQ(field.distance[2], 2.0F);
}

TEST(FastSweeping, HasTheSameBitsForAnyNumberOfThreads)
{
  SweptField serial = sphereField(40);
  sweep(serial, 3);
  for (const int threads : { 1, 2, 8 })
  {
    SweptField field = sphereField(40);
    sweep(field, 3, threadedExecution(threads, 9));
    EXPECT_EQ(field.distance, serial.distance) << threads;
  }
}
