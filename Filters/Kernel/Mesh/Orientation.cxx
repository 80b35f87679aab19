// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/Orientation.h"

#include "Mesh/Expansion.h"

#include <cmath>
#include <limits>
#include <optional>

namespace evolving
{

namespace
{

/// The largest relative error of one operation: half of what C++ calls epsilon.
constexpr double RoundOff = std::numeric_limits<double>::epsilon() / 2;

/// The sign of a determinant whose error is at most factor * permanent, if that decides it.
std::optional<int> filteredSign(double determinant, double permanent, double factor)
{
  const double bound = factor * permanent;
  if (determinant > bound)
  {
    return 1;
  }
  if (determinant < -bound)
  {
    return -1;
  }
  return permanent == 0.0 ? std::optional<int>(0) : std::nullopt;
}

/// The determinant of differences, with Shewchuk's error bound A.
std::optional<int> filteredOrientation(
  const Vec3& pointA, const Vec3& pointB, const Vec3& pointC, const Vec3& origin)
{
  constexpr double Factor = (7.0 + 56.0 * RoundOff) * RoundOff;
  const Vec3 a = pointA - origin;
  const Vec3 b = pointB - origin;
  const Vec3 c = pointC - origin;
  const Vec3 left(c[0] * b[1], a[0] * c[1], b[0] * a[1]);
  const Vec3 right(b[0] * c[1], c[0] * a[1], a[0] * b[1]);
  const Vec3 heights(a[2], b[2], c[2]);
  const double permanent = heights.cwiseAbs().dot(left.cwiseAbs() + right.cwiseAbs());
  return filteredSign(heights.dot(left - right), permanent, Factor);
}

std::optional<int> filteredPlanarOrientation(
  const Vec3& a, const Vec3& b, const Vec3& c, int x, int y)
{
  constexpr double Factor = (3.0 + 16.0 * RoundOff) * RoundOff;
  const double left = (a[x] - c[x]) * (b[y] - c[y]);
  const double right = (a[y] - c[y]) * (b[x] - c[x]);
  return filteredSign(left - right, std::abs(left) + std::abs(right), Factor);
}

/// The exact 2 x 2 determinant of the coordinates x and y of two points.
Expansion<4> exactMinor(const Vec3& p, const Vec3& q, int x, int y)
{
  return exactProduct(p[x], q[y]) + exactProduct(-p[y], q[x]);
}

/// The 4 x 4 determinant of the coordinates and ones, without differences that could round.
int exactOrientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const Expansion<4> ab = exactMinor(a, b, 0, 1);
  const Expansion<4> bc = exactMinor(b, c, 0, 1);
  const Expansion<4> cd = exactMinor(c, d, 0, 1);
  const Expansion<4> da = exactMinor(d, a, 0, 1);
  const Expansion<4> ac = exactMinor(a, c, 0, 1);
  const Expansion<4> ca = exactMinor(c, a, 0, 1);
  const Expansion<4> bd = exactMinor(b, d, 0, 1);
  const Expansion<4> db = exactMinor(d, b, 0, 1);
  const Expansion<24> termA = (bc + cd + db) * -a[2];
  const Expansion<24> termB = (cd + da + ac) * b[2];
  const Expansion<24> termC = (da + ab + bd) * -c[2];
  const Expansion<24> termD = (ab + bc + ca) * d[2];
  return ((termA + termB) + (termC + termD)).sign();
}

} // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const std::optional<int> sign = filteredOrientation(a, b, c, d);
  return sign ? *sign : exactOrientation(a, b, c, d);
}

int planarOrientation(int axis, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  const std::optional<int> sign = filteredPlanarOrientation(a, b, c, x, y);
  return sign ? *sign
              : (exactMinor(a, b, x, y) + exactMinor(b, c, x, y) + exactMinor(c, a, x, y)).sign();
}

} // namespace evolving
