// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CloseCurves.h"

#include "Features/CarriableFeatures.h"
#include "Features/FeatureCurves.h"
#include "Features/PolylineTree.h"
#include "Features/SurfacePatches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace evolving
{

namespace
{

constexpr double NearCorner = 3.0; ///< where curves that meet may be close, over the distance
constexpr double SampleStep = 0.5; ///< between samples of a curve, over the distance

/// Does the segment of an edge come within a distance of a point?
bool isNear(const TargetTriangles& target, Index edge, const Vec3& point, double distance)
{
  const auto [a, b] = target.edgeVertices(edge);
  const Vec3 along = target.point(b) - target.point(a);
  const double t = along.dot(point - target.point(a)) / along.squaredNorm();
  const Vec3 closest = target.point(a) + std::clamp(t, 0.0, 1.0) * along;
  return (point - closest).squaredNorm() < distance * distance;
}

class CloseCurves
{
public:
  CloseCurves(const TargetTriangles& target, SharpEdges& sharp, double distance)
    : Target(target)
    , Sharp(sharp)
    , Distance(distance)
    , Network(target, sharp)
    , Patches(surfacePatches(target, sharp))
    , Tree(target, sharp.list())
  {
  }

  bool run()
  {
    bool dropped = false;
    for (const Index c : this->weakestFirst())
    {
      if (this->isClose(c))
      {
        for (const Index edge : this->curve(c).edges)
        {
          this->Sharp.leaveOut(edge);
        }
        dropped = true;
      }
    }
    return dropped;
  }

private:
  const FeatureCurve& curve(Index c) const
  {
    return this->Network.curves()[static_cast<std::size_t>(c)];
  }

  /// By folds in steps of SimilarFold, then by length, the longest last.
  std::vector<Index> weakestFirst() const
  {
    std::vector<Index> order(this->Network.curves().size());
    std::iota(order.begin(), order.end(), 0);
    const auto strength = [this](Index c) { return std::round(this->curve(c).fold / SimilarFold); };
    std::stable_sort(order.begin(), order.end(),
      [&](Index a, Index b)
      {
        return strength(a) != strength(b) ? strength(a) < strength(b)
                                          : this->curve(a).length < this->curve(b).length;
      });
    return order;
  }

  bool isClose(Index c) const
  {
    double close = 0.0;
    for (const Index edge : this->curve(c).edges)
    {
      const auto [a, b] = this->Target.edgeVertices(edge);
      const Vec3 along = this->Target.point(b) - this->Target.point(a);
      const int samples =
        1 + static_cast<int>(std::min(1e4, along.norm() / (SampleStep * this->Distance)));
      for (int k = 0; k < samples; ++k)
      {
        const Vec3 point = this->Target.point(a) + (k + 0.5) / samples * along;
        close += this->hasOtherNear(c, edge, point) ? along.norm() / samples : 0.0;
      }
    }
    return close > 0.5 * this->curve(c).length;
  }

  bool hasOtherNear(Index c, Index edge, const Vec3& point) const
  {
    const Vec3 reach = Vec3::Constant(this->Distance);
    const std::vector<Index> near = this->Tree.edgesIn(Box(point - reach, point + reach));
    return std::any_of(near.begin(), near.end(),
      [&](Index other)
      {
        const Index otherCurve = this->Network.curveOf(other);
        return otherCurve != c && this->Sharp.isSharp(other) &&
          isNear(this->Target, other, point, this->Distance) &&
          !this->isNearSharedCorner(c, otherCurve, point) && this->sharePatch(edge, other);
      });
  }

  bool isNearSharedCorner(Index c, Index d, const Vec3& point) const
  {
    const FeatureCurve& other = this->curve(d);
    const double reach = NearCorner * this->Distance;
    for (const Index end : { this->curve(c).vertices.front(), this->curve(c).vertices.back() })
    {
      const bool isShared = other.vertices.front() == end || other.vertices.back() == end;
      if (isShared && (point - this->Target.point(end)).squaredNorm() < reach * reach)
      {
        return true;
      }
    }
    return false;
  }

  bool sharePatch(Index edgeA, Index edgeB) const
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

  const TargetTriangles& Target;
  SharpEdges& Sharp;
  double Distance;
  FeatureCurves Network;
  TriangleLabels Patches;
  PolylineTree Tree;
};

} // namespace

bool dropCloseCurves(const TargetTriangles& target, SharpEdges& sharp, double distance)
{
  return CloseCurves(target, sharp, distance).run();
}

} // namespace evolving
