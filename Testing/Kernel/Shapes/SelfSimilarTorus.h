// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Angenent's torus, which mean curvature flow shrinks without changing its shape.
 */

#ifndef EVOLVING_TESTING_SELF_SIMILAR_TORUS_H
#define EVOLVING_TESTING_SELF_SIMILAR_TORUS_H

#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving::shapes
{

/**
 * Angenent, *Shrinking doughnuts*, 1992: the closed profile, in distance rho from the axis and
 * height z, of a torus of revolution that shrinks as sqrt(1 - t),
 *
 *   rho' = sin alpha, z' = cos alpha, alpha' = (1/rho - rho/2) cos alpha + (z/2) sin alpha,
 *
 * by arc length from the inner radius. It touches the plane z = 0 twice and is symmetric about it.
 */
class SelfSimilarTorus
{
public:
  SelfSimilarTorus();

  static constexpr double InnerRadius = 0.43712396709646;
  static constexpr double OuterRadius = 3.314708;
  static constexpr double HalfHeight = 0.921714;
  static constexpr double Area = 89.9407;
  static constexpr double Volume = 50.0171;

  /// Rings of triangles, evenly spaced along the profile; an even number of them.
  SurfaceMesh mesh(Index rings, Index around) const;
  /// How far a point is from the torus at a time below 1, to a millionth.
  double distance(const Vec3& point, double time) const;
  /// (rho, z) of the profile's upper half, from the inner radius to the outer one.
  const std::vector<Eigen::Vector2d>& profile() const { return this->Upper; }

private:
  Eigen::Vector2d at(double part) const;

  std::vector<Eigen::Vector2d> Upper; ///< at equal distances
};

} // namespace evolving::shapes

#endif
