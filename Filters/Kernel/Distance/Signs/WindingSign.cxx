// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/WindingSign.h"

#include "Distance/Signs/WindingNumber.h"
#include "Mesh/Angles.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

SurfaceMesh segmentsOf(const DistanceTarget& target)
{
  SurfaceMesh segments;
  segments.points = target.mesh.points;
  for (const auto& [from, to] : target.orientation.openEdges)
  {
    segments.addFace({ from, to, to });
  }
  return segments;
}

/// How fast the winding number can change between crossings of the surface.
class OpenEdges
{
public:
  explicit OpenEdges(const DistanceTarget& target)
    : Tree(segmentsOf(target))
    , Strength(target.orientation.openLength / (4.0 * Pi))
  {
  }

  double distance(const Vec3& point) const
  {
    return this->Tree.isEmpty() ? std::numeric_limits<double>::infinity()
                                : std::sqrt(this->Tree.closest(point).at.squaredDistance);
  }
  /// Per unit of way, at a distance.
  double largestChange(double distance) const { return this->Strength / (distance * distance); }

private:
  AABBTree Tree;
  double Strength;
};

/// Carries the side of one sample on to the next, where nothing can have changed it.
class WindingRun
{
public:
  WindingRun(const WindingNumber& winding, const OpenEdges& edges, double step)
    : Winding(winding)
    , Edges(edges)
    , Step(step)
  {
  }

  bool isInside(const Vec3& point, double clearance)
  {
    constexpr double Rounding = 1.0 + 1e-6;
    const double gap = 0.5 * (this->LastClearance + clearance - Rounding * this->Step);
    this->LastClearance = clearance;
    this->ToEdges -= this->Step;
    if (gap <= 0.0)
    {
      return this->evaluate(point);
    }
    if (this->ToEdges < std::max(gap, 0.5 * this->ToEdgesWhenMeasured))
    {
      // On the way here it was no less than at its ends less the step.
      this->ToEdges = this->ToEdgesWhenMeasured = this->Edges.distance(point) - this->Step;
    }
    this->Margin -= this->Step * this->Edges.largestChange(std::max(gap, this->ToEdges));
    return this->Margin < 0.0 ? this->evaluate(point) : this->Inside;
  }

private:
  bool evaluate(const Vec3& point)
  {
    const double winding = this->Winding.at(point);
    this->Inside = winding > WindingThreshold;
    this->Margin = std::abs(winding - WindingThreshold) - 2.0 * WindingNumber::Tolerance;
    return this->Inside;
  }

  const WindingNumber& Winding;
  const OpenEdges& Edges;
  double Step;
  double LastClearance = 0.0;
  double ToEdges = 0.0; ///< a lower bound for the distance
  double ToEdgesWhenMeasured = 0.0;
  double Margin = -1.0; ///< by how much the winding number may change without a doubt
  bool Inside = false;
};

} // namespace

std::vector<char> insideByWindingNumber(const DistanceTarget& target, const DistanceGrid& grid,
  const std::vector<float>& clearance, const Execution& execution)
{
  const WindingNumber winding(trianglesOf(target.mesh), execution.phase(0.0, 0.3));
  const OpenEdges edges(target);
  std::vector<char> inside(clearance.size(), 0);
  const int width = grid.dimension(0);
  const Extent& e = grid.extent;
  constexpr std::int64_t RowGrain = 16;
  execution.phase(0.3, 1.0).forRangeReporting(std::int64_t(grid.dimension(1)) * grid.dimension(2),
    RowGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t row = begin; row < end; ++row)
      {
        const int j = e[2] + static_cast<int>(row % grid.dimension(1));
        const int k = e[4] + static_cast<int>(row / grid.dimension(1));
        WindingRun run(winding, edges, grid.spacing.x());
        for (int i = 0; i < width; ++i)
        {
          const auto sample = static_cast<std::size_t>(row * width + i);
          inside[sample] =
            run.isInside(grid.point(e[0] + i, j, k), static_cast<double>(clearance[sample]));
        }
      }
    });
  return inside;
}

} // namespace evolving
