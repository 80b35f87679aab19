// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A triangle with everything computed beforehand that its distance to a point needs.
 */

#ifndef EVOLVING_MEASURED_TRIANGLE_H
#define EVOLVING_MEASURED_TRIANGLE_H

#include "Distance/TriangleGeometry.h"
#include "Types.h"

namespace evolving
{

/// The distance of closestPointOnTriangle() without the point, some three times as fast.
class MeasuredTriangle
{
public:
  explicit MeasuredTriangle(const Triangle& triangle);

  double squaredDistance(const Vec3& point) const;
  const Vec3& unitNormal() const { return this->Normal; } ///< zero for a degenerate triangle
  const Vec3& corner() const { return this->A; }

private:
  Vec3 A;
  Vec3 AB;
  Vec3 AC;
  Vec3 Normal;
  double ABAB = 0.0;
  double ABAC = 0.0;
  double ACAC = 0.0;
  double Total = 0.0; ///< squared double area; what the barycentric coordinates sum to
  double InverseABAB = 0.0;
  double InverseACAC = 0.0;
  double InverseBCBC = 0.0;
  bool IsDegenerate = false;
};

} // namespace evolving

#endif
