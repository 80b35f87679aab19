// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A triangle laid out for the innermost loop of this folder: how far is it from a point?
 */

#ifndef EVOLVING_MEASURED_TRIANGLE_H
#define EVOLVING_MEASURED_TRIANGLE_H

#include "Trees/TriangleGeometry.h"
#include "Types.h"

namespace evolving
{

/**
 * The distance of closestPointOnTriangle() without the point and without a branch: the three
 * edges lie side by side in SIMD registers, whose fourth place repeats the first.
 * With floats, coordinates lose what lies below 1e-7 of the largest of them.
 */
template <typename Scalar>
class MeasuredTriangle
{
public:
  using Vector = Eigen::Matrix<Scalar, 3, 1>;

  explicit MeasuredTriangle(const Triangle& triangle);

  Scalar squaredDistance(const Vector& point) const;
  /// Zero for a degenerate triangle.
  Vector unitNormal() const { return this->Normal.template head<3>().matrix(); }
  Vector corner() const { return { this->X[0], this->Y[0], this->Z[0] }; }

private:
  using Edges = Eigen::Array<Scalar, 4, 1>;

  Edges X; ///< where edge k begins
  Edges Y;
  Edges Z;
  Edges AlongX; ///< from there to where it ends
  Edges AlongY;
  Edges AlongZ;
  Edges InverseSquare; ///< of its length; 0 for an edge of no length
  Edges Normal;        ///< its first three are the unit normal
};

template <typename Scalar>
MeasuredTriangle<Scalar>::MeasuredTriangle(const Triangle& triangle)
  : Normal(Edges::Zero())
{
  for (int k = 0; k < 4; ++k)
  {
    const Vec3& from = triangle.corners[static_cast<std::size_t>(k % 3)];
    const Vec3& to = triangle.corners[static_cast<std::size_t>((k + 1) % 3)];
    const Vector start = from.cast<Scalar>();
    const Vector along = (to - from).cast<Scalar>();
    this->X[k] = start.x();
    this->Y[k] = start.y();
    this->Z[k] = start.z();
    this->AlongX[k] = along.x();
    this->AlongY[k] = along.y();
    this->AlongZ[k] = along.z();
    const Scalar square = along.squaredNorm();
    this->InverseSquare[k] = square > Scalar(0) ? Scalar(1) / square : Scalar(0);
  }
  if (!isDegenerate(triangle))
  {
    const Vec3 normal = triangle.doubleAreaNormal();
    this->Normal.template head<3>() = (normal / normal.norm()).array().cast<Scalar>();
  }
}

template <typename Scalar>
inline Scalar MeasuredTriangle<Scalar>::squaredDistance(const Vector& point) const
{
  const Edges x = point.x() - this->X;
  const Edges y = point.y() - this->Y;
  const Edges z = point.z() - this->Z;
  // Inside an edge when the normal, the edge and the way to the point turn counter-clockwise.
  const Edges inside = this->Normal[0] * (this->AlongY * z - this->AlongZ * y) +
    this->Normal[1] * (this->AlongZ * x - this->AlongX * z) +
    this->Normal[2] * (this->AlongX * y - this->AlongY * x);
  const Edges product = this->AlongX * x + this->AlongY * y + this->AlongZ * z;
  const Edges t = (product * this->InverseSquare).max(Scalar(0)).min(Scalar(1));
  const Edges toEdge = (x - t * this->AlongX).square() + (y - t * this->AlongY).square() +
    (z - t * this->AlongZ).square();
  const Scalar height = this->Normal[0] * x[0] + this->Normal[1] * y[0] + this->Normal[2] * z[0];
  return inside.minCoeff() > Scalar(0) ? height * height : toEdge.minCoeff();
}

} // namespace evolving

#endif
