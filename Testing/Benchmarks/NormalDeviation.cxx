// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "NormalDeviation.h"

#include "Mesh/Angles.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <cmath>

namespace benchmark
{

namespace
{

using evolving::Index;
using evolving::SurfaceMesh;
using evolving::Vec3;

/// Of a face that is clearly wrong: one that cuts a corner off, or a tooth of a saw.
constexpr double WrongAngle = 20.0;

Vec3 middleOf(const SurfaceMesh& surface, Index face)
{
  return (surface.facePoint(face, 0) + surface.facePoint(face, 1) + surface.facePoint(face, 2)) /
    3.0;
}

/// In degrees, 90 at most.
double angleBetweenLines(const Vec3& a, const Vec3& b)
{
  const double angle = evolving::DegreesPerRadian * evolving::angleBetween(a, b);
  return std::min(angle, 180.0 - angle);
}

} // namespace

NormalDeviation normalDeviation(const SurfaceMesh& surface, const SurfaceMesh& reference)
{
  const evolving::AABBTree tree(reference);
  NormalDeviation result;
  double area = 0.0;
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const Vec3 own = evolving::faceVectorArea(surface, face);
    const Index closest = tree.closest(middleOf(surface, face)).triangle;
    const Vec3 other = evolving::faceVectorArea(reference, closest);
    if (own.norm() > 0.0 && other.norm() > 0.0)
    {
      const double angle = angleBetweenLines(own, other);
      area += own.norm();
      result.partOver20 += angle > WrongAngle ? own.norm() : 0.0;
      result.rms += own.norm() * angle * angle;
    }
  }
  result.partOver20 /= area;
  result.rms = std::sqrt(result.rms / area);
  return result;
}

} // namespace benchmark
