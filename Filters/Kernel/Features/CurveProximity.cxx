// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CurveProximity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace evolving
{

namespace
{

/// Where curves that meet may be close, over the distance: those at more than 22 degrees, which
/// elements of any size can have (FinishTuning::leastFeatureAngle).
constexpr double NearCorner = 2.67;

double squaredDistance(const TargetTriangles& target, Index edge, const Vec3& point)
{
  const auto [a, b] = target.edgeVertices(edge);
  const Vec3 along = target.point(b) - target.point(a);
  const double t = along.dot(point - target.point(a)) / along.squaredNorm();
  const Vec3 closest = target.point(a) + std::clamp(t, 0.0, 1.0) * along;
  return (point - closest).squaredNorm();
}

} // namespace

CurveProximity::CurveProximity(const TargetTriangles& target, const SharpEdges& sharp)
  : Target(target)
  , Sharp(sharp)
  , Network(target, sharp)
  , Patches(surfacePatches(target, sharp))
  , Tree(target, sharp.list())
{
}

bool CurveProximity::hasOtherNear(Index edge, const Vec3& point, double distance) const
{
  constexpr double Enough = -1.0; // ends the visit
  bool isFound = false;
  this->Tree.visitNear(point, distance * distance,
    [&](Index other)
    {
      isFound = isFound ||
        (squaredDistance(this->Target, other, point) < distance * distance &&
          this->isOther(edge, other) &&
          !this->isNearSharedCorner(
            this->Network.curveOf(edge), this->Network.curveOf(other), point, distance) &&
          this->sharePatch(edge, other));
      return isFound ? Enough : distance * distance;
    });
  return isFound;
}

double CurveProximity::distanceToOther(Index edge, const Vec3& point, double reach) const
{
  double nearest = std::numeric_limits<double>::infinity();
  this->Tree.visitNear(point, reach * reach,
    [&](Index other)
    {
      const double distance = std::sqrt(squaredDistance(this->Target, other, point));
      if (distance < std::min(nearest, reach) && distance > 0.0 && this->isOther(edge, other) &&
        !this->isNearSharedCorner(
          this->Network.curveOf(edge), this->Network.curveOf(other), point, distance) &&
        this->sharePatch(edge, other))
      {
        nearest = distance;
      }
      return std::pow(std::min(nearest, reach), 2.0);
    });
  return nearest;
}

bool CurveProximity::isOther(Index edge, Index other) const
{
  return this->Network.curveOf(other) != this->Network.curveOf(edge) && this->Sharp.isSharp(other);
}

bool CurveProximity::isNearSharedCorner(Index c, Index d, const Vec3& point, double distance) const
{
  const FeatureCurve& curve = this->Network.curves()[at(c)];
  const FeatureCurve& other = this->Network.curves()[at(d)];
  const double reach = NearCorner * distance;
  for (const Index end : { curve.vertices.front(), curve.vertices.back() })
  {
    const bool isShared = other.vertices.front() == end || other.vertices.back() == end;
    if (isShared && (point - this->Target.point(end)).squaredNorm() < reach * reach)
    {
      return true;
    }
  }
  return false;
}

bool CurveProximity::sharePatch(Index edgeA, Index edgeB) const
{
  const TriangleEdges& edges = this->Target.edges();
  return std::any_of(edges.begin(edgeA), edges.end(edgeA),
    [&](Index a)
    {
      return std::any_of(edges.begin(edgeB), edges.end(edgeB),
        [&](Index b) {
          return this->Patches[TargetTriangles::faceOf(a)] ==
            this->Patches[TargetTriangles::faceOf(b)];
        });
    });
}

} // namespace evolving
