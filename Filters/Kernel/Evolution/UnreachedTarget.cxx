// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/UnreachedTarget.h"

#include "Evolution/ZeroLevel.h"
#include "Mesh/DisjointSets.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/PolygonTriangulation.h"
#include "ParallelLoops.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace evolving
{

namespace
{

/// Between samples that see the target from both sides a distance is rounded off by a cell.
constexpr double CellsFromTarget = 1.0;
/// Samples next to the level, and pieces of it, are so thick.
constexpr double CellsFromSurface = 2.0;
/// In these lengths: what is shorter is a detail that the elements do not show.
constexpr double ShortestPiece = 2.0;

void sortByWidth(std::vector<UnreachedPlace>& places)
{
  std::stable_sort(places.begin(), places.end(),
    [](const UnreachedPlace& a, const UnreachedPlace& b) { return a.width > b.width; });
}

/// Connected vertices that are away, each group by its farthest one.
std::vector<UnreachedPlace> membranesOf(
  const SurfaceMesh& surface, const std::vector<double>& away, double tolerance)
{
  DisjointSets groups(surface.points.size());
  for (Index f = 0; f < surface.faceCount(); ++f)
  {
    for (Index k = 0; k < surface.faceSize(f); ++k)
    {
      const Index from = surface.faceVertex(f, k);
      const Index to = surface.faceVertex(f, (k + 1) % surface.faceSize(f));
      if (away[at(from)] > tolerance && away[at(to)] > tolerance)
      {
        groups.join(from, to);
      }
    }
  }
  std::map<Index, Index> farthest; // by group
  for (Index v = 0; v < surface.vertexCount(); ++v)
  {
    if (away[at(v)] > tolerance)
    {
      Index& best = farthest.emplace(groups.find(v), v).first->second;
      best = away[at(v)] > away[at(best)] ? v : best;
    }
  }
  std::vector<UnreachedPlace> membranes;
  for (const auto& [group, v] : farthest)
  {
    membranes.push_back({ surface.points[at(v)], 2.0 * away[at(v)] });
  }
  sortByWidth(membranes);
  return membranes;
}

/// Samples are neighbours where they differ by one along any axes.
class SampleGroups
{
public:
  SampleGroups(const DistanceGrid& grid, const std::vector<LevelSample>& samples)
    : Samples(samples)
    , Sets(samples.size())
  {
    std::unordered_map<GridIndex, Index> bySample;
    for (std::size_t s = 0; s < samples.size(); ++s)
    {
      const auto& [i, j, k] = samples[s].ijk;
      bySample.emplace(grid.index(i, j, k), static_cast<Index>(s));
    }
    for (std::size_t s = 0; s < samples.size(); ++s)
    {
      this->joinWithNeighbours(grid, bySample, static_cast<Index>(s));
    }
  }

  /// Those that are no shorter than a length: others are a sample or two.
  std::vector<UnreachedPlace> places(double shortest)
  {
    std::map<Index, std::vector<Index>> groups;
    for (std::size_t s = 0; s < this->Samples.size(); ++s)
    {
      const auto sample = static_cast<Index>(s);
      groups[this->Sets.find(sample)].push_back(sample);
    }
    std::vector<UnreachedPlace> places;
    for (const auto& [root, group] : groups)
    {
      const UnreachedPlace place = this->placeOf(group);
      if (place.width >= shortest)
      {
        places.push_back(place);
      }
    }
    sortByWidth(places);
    return places;
  }

private:
  void joinWithNeighbours(
    const DistanceGrid& grid, const std::unordered_map<GridIndex, Index>& bySample, Index s)
  {
    const auto& [i, j, k] = this->Samples[at(s)].ijk;
    const Extent& e = grid.extent;
    for (int c = std::max(k - 1, e[4]); c <= std::min(k + 1, e[5]); ++c)
    {
      for (int b = std::max(j - 1, e[2]); b <= std::min(j + 1, e[3]); ++b)
      {
        for (int a = std::max(i - 1, e[0]); a <= std::min(i + 1, e[1]); ++a)
        {
          const auto found = bySample.find(grid.index(a, b, c));
          if (found != bySample.end())
          {
            this->Sets.join(s, found->second);
          }
        }
      }
    }
  }

  UnreachedPlace placeOf(const std::vector<Index>& group) const
  {
    Box box;
    for (const Index s : group)
    {
      box.extend(this->Samples[at(s)].point);
    }
    const auto nearest = std::min_element(group.begin(), group.end(),
      [&](Index a, Index b) { return this->fromMiddle(box, a) < this->fromMiddle(box, b); });
    return { this->Samples[at(*nearest)].point, box.diagonal().norm() };
  }

  double fromMiddle(const Box& box, Index s) const
  {
    return (this->Samples[at(s)].point - box.center()).squaredNorm();
  }

  const std::vector<LevelSample>& Samples;
  DisjointSets Sets;
};

/// The samples of the level from which the surface is farther than the level by the tolerance.
std::vector<LevelSample> unreachedSamples(const std::vector<LevelSample>& level,
  const SurfaceMesh& surface, double tolerance, const Execution& execution)
{
  const AABBTree tree(surface, execution.phase(0.0, 0.2));
  std::vector<char> isReached(level.size());
  forEachIndex(execution.phase(0.2, 1.0), static_cast<std::int64_t>(level.size()),
    [&](Index s)
    {
      const LevelSample& sample = level[at(s)];
      const double reach = sample.distance + tolerance;
      isReached[at(s)] = tree.closest(sample.point, reach * reach).triangle != NoIndex ? 1 : 0;
    });
  std::vector<LevelSample> unreached;
  for (std::size_t s = 0; s < level.size(); ++s)
  {
    if (!isReached[s])
    {
      unreached.push_back(level[s]);
    }
  }
  return unreached;
}

double areaOf(const std::vector<LevelSample>& samples)
{
  double area = 0.0;
  for (const LevelSample& sample : samples)
  {
    area += sample.area;
  }
  return area;
}

} // namespace

UnreachedTarget findUnreachedTarget(const ScalarImage& distance, const SurfaceMesh& surface,
  const AwayFrom& away, const Execution& execution)
{
  UnreachedTarget unreached;
  std::vector<double> distances(surface.points.size());
  forEachIndex(execution.phase(0.0, 0.1), static_cast<std::int64_t>(distances.size()),
    [&](Index v) { distances[at(v)] = std::abs(distance.at(surface.points[at(v)]).value); });
  unreached.membranes = membranesOf(surface, distances, away.target);
  const std::vector<LevelSample> level = zeroLevel(distance);
  std::vector<Index> oldFace;
  const std::vector<LevelSample> left =
    unreachedSamples(level, triangulate(surface, oldFace, execution.phase(0.1, 0.2)), away.surface,
      execution.phase(0.2, 1.0));
  unreached.pieces = SampleGroups(distance.grid(), left).places(ShortestPiece * away.surface);
  unreached.part = left.empty() ? 0.0 : areaOf(left) / areaOf(level);
  return unreached;
}

bool shouldHaveArrived(
  const FlowState& state, double farthest, double advectionSpeed, double tolerance)
{
  return state.hasConverged || std::exp(-advectionSpeed * state.record.time) * farthest < tolerance;
}

AwayFrom awayFrom(const ScalarImage& distance, const SurfaceMesh& surface)
{
  const double cell = distance.grid().spacing.maxCoeff();
  return { CellsFromTarget * cell, std::max(CellsFromSurface * cell, meanEdgeLength(surface)) };
}

std::string unreachedInWords(const ScalarImage& distance, const FlowState& last, double farthest,
  double advectionSpeed, const Execution& execution)
{
  const SurfaceMesh surface = last.mesh();
  const AwayFrom away = awayFrom(distance, surface);
  return shouldHaveArrived(last, farthest, advectionSpeed, away.target)
    ? inWords(findUnreachedTarget(distance, surface, away, execution))
    : std::string();
}

} // namespace evolving
