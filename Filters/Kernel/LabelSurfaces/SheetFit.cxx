// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/SheetFit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

constexpr std::size_t LeastForPlane = 3;
constexpr std::size_t LeastForQuadric = 10;
/// Of the normal equations, in points at the place: slopes and bends that nothing speaks for are 0.
constexpr double SlopeDamping = 0.01;
constexpr double BendDamping = 1.0;
/// The plane of the first fit is the one that the second is done over.
constexpr int Rounds = 2;

using Coefficients = Eigen::Matrix<double, 6, 1>; // 1, u, v, u u, u v, v v
using NormalMatrix = Eigen::Matrix<double, 6, 6>;

/// One round; the plane is the tangent plane at the quadric's point above the place.
SheetPlane fitOver(
  const std::vector<Vec3>& points, const Vec3& place, const Vec3& normal, double radius)
{
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.cross(u);
  NormalMatrix matrix = NormalMatrix::Zero();
  Coefficients sums = Coefficients::Zero();
  for (const Vec3& point : points)
  {
    const Vec3 d = (point - place) / radius;
    const double a = d.dot(u);
    const double b = d.dot(v);
    Coefficients row;
    row << 1.0, a, b, a * a, a * b, b * b;
    const double weight = std::exp(-0.5 * d.squaredNorm());
    matrix += weight * row * row.transpose();
    sums += weight * d.dot(normal) * row;
  }
  matrix.diagonal().segment<2>(1).array() += SlopeDamping;
  matrix.diagonal().tail<3>().array() += BendDamping;
  if (points.size() < LeastForQuadric)
  {
    matrix.bottomLeftCorner<3, 3>().setZero();
    matrix.topRightCorner<3, 3>().setZero();
    sums.tail<3>().setZero();
  }
  const NormalMatrix inverse = matrix.ldlt().solve(NormalMatrix::Identity());
  const Coefficients c = inverse * sums;
  SheetPlane plane;
  plane.normal = (normal - c[1] * u - c[2] * v).normalized();
  plane.offset = radius * c[0] * plane.normal.dot(normal);
  plane.weight = std::min(1.0, 1.0 / inverse(0, 0));
  return plane;
}

} // namespace

std::optional<SheetPlane> fitSheet(
  const std::vector<Vec3>& points, const Vec3& place, const Vec3& normal, double radius)
{
  if (points.size() < LeastForPlane)
  {
    return std::nullopt;
  }
  SheetPlane plane;
  plane.normal = normal;
  for (int round = 0; round < Rounds; ++round)
  {
    plane = fitOver(points, place, plane.normal, radius);
  }
  return std::isfinite(plane.offset) ? std::optional<SheetPlane>(plane) : std::nullopt;
}

} // namespace evolving
