// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/Orientation.h"
#include "Shapes/MeshVariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

__extension__ using Wide = __int128;
using IntegerPoint = std::array<std::int64_t, 3>;

int signOf(Wide value)
{
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

/// Exact for coordinates up to 2^40.
int integerOrientation(
  const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c, const IntegerPoint& d)
{
  Wide u[3];
  Wide v[3];
  Wide w[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    u[i] = b[i] - a[i];
    v[i] = c[i] - a[i];
    w[i] = d[i] - a[i];
  }
  return signOf((u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
    (u[0] * v[1] - u[1] * v[0]) * w[2]);
}

Vec3 asDoubles(const IntegerPoint& p)
{
  return { static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]) };
}

IntegerPoint combined(const IntegerPoint& a, const IntegerPoint& b, std::int64_t k, std::int64_t n)
{
  IntegerPoint result;
  for (std::size_t i = 0; i < 3; ++i)
  {
    result[i] = a[i] + (b[i] - a[i]) / n * k;
  }
  return result;
}

TEST(Orientation, SignsOfTheUnitTetrahedron)
{
  const Vec3 o(0, 0, 0);
  const Vec3 x(1, 0, 0);
  const Vec3 y(0, 1, 0);
  const Vec3 z(0, 0, 1);
  EXPECT_EQ(orientation(o, x, y, z), 1);
  EXPECT_EQ(orientation(o, y, x, z), -1);
  EXPECT_EQ(orientation(o, x, y, x + y), 0);
  EXPECT_EQ(planarOrientation(2, o, x, y), 1);
  EXPECT_EQ(planarOrientation(0, o, y, z), 1);
  EXPECT_EQ(planarOrientation(1, o, z, x), 1);
  EXPECT_EQ(planarOrientation(1, o, x, z), -1);
  EXPECT_EQ(planarOrientation(2, o, x, z), 0);
}

TEST(Orientation, AgreesWithIntegersWhereRoundingWouldDecide)
{
  std::mt19937_64 generator(17);
  std::uniform_int_distribution<std::int64_t> wide(-(1LL << 39), 1LL << 39);
  std::uniform_int_distribution<std::int64_t> small(-2, 2);
  std::uniform_int_distribution<std::int64_t> part(1, 1000);
  int zeros = 0;
  for (int trial = 0; trial < 20000; ++trial)
  {
    const IntegerPoint a{ wide(generator), wide(generator), wide(generator) };
    const IntegerPoint b{ wide(generator), wide(generator), wide(generator) };
    // Almost on the line ab, then almost in the plane abc: the determinant all but cancels.
    IntegerPoint c = combined(a, b, part(generator), 1000);
    IntegerPoint d = combined(a, c, part(generator), 1000);
    for (std::size_t i = 0; i < 3; ++i)
    {
      c[i] += small(generator);
      d[i] += small(generator);
      d[i] = trial % 5 == 0 ? b[i] + c[i] - a[i] + trial % 2 : d[i]; // every tenth is coplanar
    }
    const int expected = integerOrientation(a, b, c, d);
    zeros += expected == 0 ? 1 : 0;
    ASSERT_EQ(orientation(asDoubles(a), asDoubles(b), asDoubles(c), asDoubles(d)), expected);
  }
  EXPECT_GE(zeros, 2000);
  EXPECT_LT(zeros, 3000);
}

TEST(Orientation, KnowsTheLastBitOfACoordinate)
{
  // The plane x + y = 2 z and points one unit in the last place around it (Kettner et al. 2008).
  const double ulp = std::numeric_limits<double>::epsilon() / 2;
  const Vec3 a(12, 12, 12);
  const Vec3 b(24, 12, 18);
  const Vec3 c(12, 25, 18.5);
  for (int i = 0; i < 24; ++i)
  {
    for (int j = 0; j < 24; ++j)
    {
      for (int k = 0; k < 24; ++k)
      {
        const Vec3 d(0.5 + i * ulp, 0.5 + j * ulp, 0.5 + k * ulp);
        ASSERT_EQ(orientation(a, b, c, d), signOf(2 * k - i - j)) << i << ' ' << j << ' ' << k;
      }
      const Vec3 p(0.5 + i * ulp, 0.5 + j * ulp, 0.0);
      ASSERT_EQ(planarOrientation(2, Vec3(12, 12, 7), Vec3(24, 24, 9), p), signOf(j - i));
    }
  }
}

TEST(Orientation, ChangesSignWithEverySwapOfAlmostCoplanarPoints)
{
  std::mt19937 generator(23);
  std::uniform_real_distribution<double> weight(-2.0, 2.0);
  int decided = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    std::array<Vec3, 4> p;
    for (std::size_t i = 0; i < 3; ++i)
    {
      p[i] = randomPoint(generator);
    }
    p[3] = p[0] + weight(generator) * (p[1] - p[0]) + weight(generator) * (p[2] - p[0]);
    const int sign = orientation(p[0], p[1], p[2], p[3]);
    decided += std::abs(sign);
    std::array<std::size_t, 4> order{ 0, 1, 2, 3 };
    do
    {
      int inversions = 0;
      for (std::size_t i = 0; i < 4; ++i)
      {
        for (std::size_t j = i + 1; j < 4; ++j)
        {
          inversions += order[i] > order[j] ? 1 : 0;
        }
      }
      const int permuted = orientation(p[order[0]], p[order[1]], p[order[2]], p[order[3]]);
      ASSERT_EQ(permuted, inversions % 2 == 0 ? sign : -sign);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  EXPECT_GT(decided, 1900) << "rounded points are hardly ever exactly coplanar";
}

TEST(Orientation, IsZeroForRepeatedPointsAnywhere)
{
  std::mt19937 generator(29);
  for (const double scale : { 1e-60, 1.0, 1e60 })
  {
    const Vec3 a = scale * randomPoint(generator);
    const Vec3 b = scale * randomPoint(generator);
    const Vec3 c = scale * randomPoint(generator);
    EXPECT_EQ(orientation(a, b, c, b), 0);
    EXPECT_EQ(orientation(a, a, b, c), 0);
    EXPECT_EQ(planarOrientation(1, a, b, a), 0);
  }
}

} // namespace

} // namespace evolving
