// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/SurfaceReport.h"

#include "Distance/AABBTree.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TopologySummary.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// Points as triangles without extent, so that one tree serves both.
SurfaceMesh asTriangles(const SurfaceMesh& target)
{
  SurfaceMesh triangles = target;
  if (target.faceCount() == 0)
  {
    for (Index v = 0; v < target.vertexCount(); ++v)
    {
      triangles.addFace({ v, v, v });
    }
  }
  return triangles;
}

double largestDistance(
  const SurfaceMesh& surface, const SurfaceMesh& target, double level, const Execution& execution)
{
  const AABBTree tree(asTriangles(target), execution.phase(0.0, 0.3));
  std::vector<double> distance(surface.points.size());
  execution.phase(0.3, 1.0).forRangeReporting(surface.vertexCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto v = static_cast<std::size_t>(begin); v < static_cast<std::size_t>(end); ++v)
      {
        const ClosestTriangle closest = tree.closest(surface.points[v]);
        distance[v] = std::abs((closest.at.point - surface.points[v]).norm() - level);
      }
    });
  return distance.empty() ? 0.0 : *std::max_element(distance.begin(), distance.end());
}

} // namespace

SurfaceReport examine(
  const SurfaceMesh& surface, const SurfaceMesh& target, double level, const Execution& execution)
{
  const TopologySummary topology = summarizeTopology(surface);
  SurfaceReport report;
  report.isClosed = topology.isClosed();
  report.isManifold = topology.isManifold() && topology.isOriented();
  report.genus = report.isClosed && report.isManifold ? topology.genus() : -1;
  report.selfIntersections =
    static_cast<Index>(selfIntersections(surface, execution.phase(0.0, 0.5)).size());
  report.minAngle = smallestAngle(surface);
  report.maxDistance = largestDistance(surface, target, level, execution.phase(0.5, 1.0));
  return report;
}

} // namespace evolving
