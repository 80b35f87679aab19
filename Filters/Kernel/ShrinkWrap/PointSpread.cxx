// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/PointSpread.h"

#include "Errors.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <tuple>

namespace evolving
{

namespace
{

/// Along the axis of the second largest spread, as a part of the largest one.
double spreadBesideLine(const SurfaceMesh& points)
{
  const Box box = boundingBox(points);
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points.points)
  {
    const Vec3 p = (point - box.center()) / box.diagonal().norm(); // no under- or overflow
    mean += p / points.vertexCount();
    moments += p * p.transpose() / points.vertexCount();
  }
  moments -= mean * mean.transpose();
  const Vec3 spread = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvalues();
  return std::sqrt(std::max(0.0, spread[1]) / spread[2]);
}

} // namespace

SurfaceMesh differentPoints(const SurfaceMesh& points)
{
  std::set<std::tuple<double, double, double>> seen;
  SurfaceMesh different;
  for (const Vec3& p : points.points)
  {
    if (seen.emplace(p.x(), p.y(), p.z()).second)
    {
      different.addPoint(p);
    }
  }
  return different;
}

void requireExtent(const SurfaceMesh& points)
{
  constexpr Index Fewest = 4; // a tetrahedron
  constexpr double StraightLine =
    1e-6; // points stored as floats are as far from a line by rounding
  if (points.vertexCount() < Fewest || spreadBesideLine(points) < StraightLine)
  {
    std::ostringstream message;
    message << "The input has no faces and " << points.vertexCount()
            << " different points, too few or all on a line; expected at least " << Fewest
            << " points on a surface, or faces.";
    throw InputError(message.str());
  }
}

} // namespace evolving
