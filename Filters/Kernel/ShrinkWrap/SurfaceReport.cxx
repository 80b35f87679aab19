// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/SurfaceReport.h"

#include "Mesh/MeshQuality.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

Vec3 middleOf(const SurfaceMesh& surface, Index face)
{
  return (surface.facePoint(face, 0) + surface.facePoint(face, 1) + surface.facePoint(face, 2)) /
    3.0;
}

void findLargestDeviation(const SurfaceMesh& surface, const Deviation& deviation,
  const Execution& execution, SurfaceReport& report)
{
  std::vector<double> distance(surface.points.size());
  execution.forRangeReporting(surface.vertexCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto v = static_cast<std::size_t>(begin); v < static_cast<std::size_t>(end); ++v)
      {
        distance[v] = deviation(surface.points[v]);
      }
    });
  const auto farthest = std::max_element(distance.begin(), distance.end());
  if (farthest != distance.end())
  {
    report.maxDistance = *farthest;
    report.maxDistancePlace = surface.points[static_cast<std::size_t>(farthest - distance.begin())];
  }
}

void findSmallestAngle(const SurfaceMesh& surface, SurfaceReport& report)
{
  report.minAngle = surface.faceCount() > 0 ? 180.0 : 0.0;
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const double angle = smallestAngle(surface, face);
    if (angle < report.minAngle)
    {
      report.minAngle = angle;
      report.minAnglePlace = middleOf(surface, face);
    }
  }
}

} // namespace

SurfaceReport examine(
  const SurfaceMesh& surface, const Deviation& deviation, const Execution& execution)
{
  const TopologySummary topology = summarizeTopology(surface);
  SurfaceReport report;
  report.isClosed = topology.isClosed();
  report.isManifold = topology.isManifold() && topology.isOriented();
  report.components = topology.components;
  report.genus = report.isClosed && report.isManifold ? topology.genus() : -1;
  const auto pairs = selfIntersections(surface, execution.phase(0.0, 0.5));
  report.selfIntersections = static_cast<Index>(pairs.size());
  if (!pairs.empty())
  {
    report.intersectionPlace = middleOf(surface, pairs.front().first);
  }
  findSmallestAngle(surface, report);
  findLargestDeviation(surface, deviation, execution.phase(0.5, 1.0), report);
  return report;
}

void measureLoss(const SurfaceMesh& surface, const std::vector<Vec3>& samples, double far,
  SurfaceReport& report, const Execution& execution)
{
  const AABBTree tree(surface, execution.phase(0.0, 0.3));
  std::vector<double> squared(samples.size(), std::numeric_limits<double>::infinity());
  const Execution now = execution.phase(0.3, 1.0);
  now.forRange(static_cast<std::int64_t>(samples.size()), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto s = static_cast<std::size_t>(begin); s < static_cast<std::size_t>(end); ++s)
      {
        const ClosestTriangle closest = tree.closest(samples[s]);
        squared[s] = closest.triangle == NoIndex ? squared[s] : closest.at.squaredDistance;
      }
    });
  const auto lost = std::count_if(
    squared.begin(), squared.end(), [far](double distance) { return distance > far * far; });
  if (lost > 0)
  {
    const auto farthest = std::max_element(squared.begin(), squared.end()) - squared.begin();
    report.lostPart = static_cast<double>(lost) / static_cast<double>(samples.size());
    report.lostPlace = samples[static_cast<std::size_t>(farthest)];
  }
}

} // namespace evolving
