// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/MeasuredTriangle.h"

#include <algorithm>
#include <limits>

namespace evolving
{

namespace
{

double inverse(double square)
{
  return square > 0.0 ? 1.0 / square : 0.0;
}

/// The squared distance to a segment of squared length l from a point whose squared distance
/// from its start is d, and whose foot along it has the dot product f.
double toSegment(double d, double f, double l, double inverseL)
{
  const double t = std::clamp(f * inverseL, 0.0, 1.0);
  return d - t * (2.0 * f - t * l);
}

} // namespace

MeasuredTriangle::MeasuredTriangle(const Triangle& triangle)
  : A(triangle.corners[0])
  , AB(triangle.corners[1] - triangle.corners[0])
  , AC(triangle.corners[2] - triangle.corners[0])
  , Normal(Vec3::Zero())
{
  this->ABAB = this->AB.squaredNorm();
  this->ABAC = this->AB.dot(this->AC);
  this->ACAC = this->AC.squaredNorm();
  this->InverseABAB = inverse(this->ABAB);
  this->InverseACAC = inverse(this->ACAC);
  this->InverseBCBC = inverse((this->AC - this->AB).squaredNorm());
  const Vec3 normal = this->AB.cross(this->AC);
  this->Total = normal.squaredNorm();
  this->IsDegenerate = isDegenerate(triangle);
  if (!this->IsDegenerate)
  {
    this->Normal = normal.normalized();
  }
}

double MeasuredTriangle::squaredDistance(const Vec3& point) const
{
  const Vec3 d = point - this->A;
  const double alongB = this->AB.dot(d);
  const double alongC = this->AC.dot(d);
  const double inB = alongB * this->ACAC - alongC * this->ABAC;
  const double inC = alongC * this->ABAB - alongB * this->ABAC;
  const double inA = this->Total - inB - inC;
  if (inA > 0.0 && inB > 0.0 && inC > 0.0 && !this->IsDegenerate)
  {
    const double height = this->Normal.dot(d);
    return height * height;
  }
  const double dd = d.squaredNorm();
  double best = std::numeric_limits<double>::infinity();
  if (inC <= 0.0 || this->IsDegenerate)
  {
    best = toSegment(dd, alongB, this->ABAB, this->InverseABAB);
  }
  if (inB <= 0.0 || this->IsDegenerate)
  {
    best = std::min(best, toSegment(dd, alongC, this->ACAC, this->InverseACAC));
  }
  if (inA <= 0.0 || this->IsDegenerate)
  {
    const double squaredBC = this->ABAB - 2.0 * this->ABAC + this->ACAC;
    const double fromB = dd - 2.0 * alongB + this->ABAB;
    const double alongBC = alongC - alongB - this->ABAC + this->ABAB;
    best = std::min(best, toSegment(fromB, alongBC, squaredBC, this->InverseBCBC));
  }
  return std::max(best, 0.0);
}

} // namespace evolving
