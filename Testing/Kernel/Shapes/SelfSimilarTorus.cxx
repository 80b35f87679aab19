// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Shapes/SelfSimilarTorus.h"

#include "Mesh/Angles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving::shapes
{

namespace
{

/// (rho, z, alpha)
using State = Eigen::Vector3d;

State slope(const State& s)
{
  const double sine = std::sin(s[2]);
  const double cosine = std::cos(s[2]);
  return { sine, cosine, (1.0 / s[0] - 0.5 * s[0]) * cosine + 0.5 * s[1] * sine };
}

/// Runge and Kutta's.
State ahead(const State& s, double length)
{
  const State k1 = slope(s);
  const State k2 = slope(s + 0.5 * length * k1);
  const State k3 = slope(s + 0.5 * length * k2);
  const State k4 = slope(s + length * k3);
  return s + length / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

const State Start(SelfSimilarTorus::InnerRadius, 0.0, 0.0);

/// From the start to the plane z = 0.
double lengthOfHalf()
{
  constexpr double Step = 1e-4;
  State s = Start;
  double length = 0.0;
  for (State next = ahead(s, Step); next[1] > 0.0; next = ahead(s, Step))
  {
    s = next;
    length += Step;
  }
  return length + s[1]; // it meets the plane at a right angle
}

} // namespace

SelfSimilarTorus::SelfSimilarTorus()
{
  constexpr int Parts = 4096;
  const double length = lengthOfHalf();
  State s = Start;
  for (int k = 0; k <= Parts; ++k)
  {
    this->Upper.emplace_back(s[0], s[1]);
    s = ahead(s, length / Parts);
  }
}

/// @param part of the whole profile, 0 to 1
Eigen::Vector2d SelfSimilarTorus::at(double part) const
{
  const double upper = 1.0 - std::abs(2.0 * part - 1.0);
  const double place = upper * static_cast<double>(this->Upper.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(place), this->Upper.size() - 2);
  const double rest = place - static_cast<double>(k);
  const Eigen::Vector2d point = (1.0 - rest) * this->Upper[k] + rest * this->Upper[k + 1];
  return { point[0], part > 0.5 ? -point[1] : point[1] };
}

SurfaceMesh SelfSimilarTorus::mesh(Index rings, Index around) const
{
  SurfaceMesh mesh;
  for (Index j = 0; j < rings; ++j)
  {
    const Eigen::Vector2d p = this->at(static_cast<double>(j) / rings);
    for (Index k = 0; k < around; ++k)
    {
      const double angle = 2.0 * Pi * (k + 0.5 * (j % 2)) / around;
      mesh.addPoint(Vec3(p[0] * std::cos(angle), p[0] * std::sin(angle), p[1]));
    }
  }
  for (Index j = 0; j < rings; ++j)
  {
    for (Index k = 0; k < around; ++k)
    {
      const Index next = (k + 1) % around;
      const Index row = j * around;
      const Index other = (j + 1) % rings * around;
      // Rows are shifted by half an edge, to and fro.
      const bool isEven = j % 2 == 0;
      mesh.addFace({ row + k, other + (isEven ? k : next), row + next });
      mesh.addFace({ other + next, isEven ? row + next : row + k, other + k });
    }
  }
  return signedVolume(mesh) < 0.0 ? reversed(mesh) : mesh;
}

double SelfSimilarTorus::distance(const Vec3& point, double time) const
{
  const double scale = std::sqrt(1.0 - time);
  const Eigen::Vector2d p(point.head<2>().norm() / scale, std::abs(point.z()) / scale);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < this->Upper.size(); ++k)
  {
    const Eigen::Vector2d edge = this->Upper[k + 1] - this->Upper[k];
    const double part = std::clamp((p - this->Upper[k]).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (this->Upper[k] + part * edge - p).squaredNorm());
  }
  return scale * std::sqrt(nearest);
}

} // namespace evolving::shapes
