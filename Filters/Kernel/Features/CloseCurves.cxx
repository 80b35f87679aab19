// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CloseCurves.h"

#include "Features/CarriableFeatures.h"
#include "Features/CurveProximity.h"
#include "Features/FeatureCurves.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace evolving
{

namespace
{

constexpr double SampleStep = 0.5; ///< between samples of a curve, over the distance

class CloseCurves
{
public:
  CloseCurves(const TargetTriangles& target, SharpEdges& sharp, double distance)
    : Target(target)
    , Sharp(sharp)
    , Distance(distance)
    , Proximity(target, sharp)
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
    return this->Proximity.network().curves()[static_cast<std::size_t>(c)];
  }

  /// By folds in steps of SimilarFold, then by length, the longest last.
  std::vector<Index> weakestFirst() const
  {
    std::vector<Index> order(this->Proximity.network().curves().size());
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
        close +=
          this->Proximity.hasOtherNear(edge, point, this->Distance) ? along.norm() / samples : 0.0;
      }
    }
    return close > 0.5 * this->curve(c).length;
  }

  const TargetTriangles& Target;
  SharpEdges& Sharp;
  double Distance;
  CurveProximity Proximity;
};

} // namespace

bool dropCloseCurves(const TargetTriangles& target, SharpEdges& sharp, double distance)
{
  return CloseCurves(target, sharp, distance).run();
}

} // namespace evolving
