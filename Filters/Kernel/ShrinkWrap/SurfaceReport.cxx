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
#include <sstream>

namespace evolving
{

namespace
{

/// A result with a smaller angle than this, in degrees, is no good for simulation: about what
/// refinement in the plane guarantees (20.7; Ruppert, *A Delaunay Refinement Algorithm for Quality
/// 2-Dimensional Mesh Generation*, 1995).
constexpr double QualityFloor = 20.0;
/// Losing less than this part of the target is no shortcoming: slits between parts and the corners
/// of sheets are lost always.
constexpr double MostLost = 0.02;
/// Nor is missing less than this part of the length of all creases: their tips.
constexpr double MissingPart = 0.01;

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

std::vector<std::string> shortcomings(const SurfaceReport& report, double edgeLength)
{
  std::vector<std::string> sentences;
  const auto say = [&sentences](const auto&... parts)
  {
    std::ostringstream sentence;
    (sentence << ... << parts);
    sentences.push_back(sentence.str());
  };
  if (!report.isClosed || !report.isManifold)
  {
    say("The result is not a closed manifold; use more SampleDimensions.");
  }
  if (report.selfIntersections > 0)
  {
    say("The result has ", report.selfIntersections, " pairs of triangles that intersect, one at (",
      report.intersectionPlace.transpose(), "); use a smaller TargetEdgeLength.");
  }
  if (report.minAngle < QualityFloor)
  {
    say("The smallest angle of the result is ", report.minAngle, " degrees, below ", QualityFloor,
      ", at (", report.minAnglePlace.transpose(), "); use a smaller TargetEdgeLength.");
  }
  if (report.maxDistance > FarEdges * edgeLength)
  {
    say("A point of the result at (", report.maxDistancePlace.transpose(), ") is ",
      report.maxDistance, " away from where it should be, more than two edge lengths (",
      FarEdges * edgeLength,
      "): a membrane was left over a hole or a deep concavity, or the distance grid is too coarse; "
      "use the Isosurface start, a smaller GapSize or more SampleDimensions.");
  }
  if (report.lostPart > MostLost)
  {
    say("Of the target, ", std::round(100.0 * report.lostPart),
      " % is more than two edge lengths (", FarEdges * edgeLength,
      ") away from the result, some at (", report.lostPlace.transpose(),
      "): it is thinner than a triangle, or in a gap that was closed; use a smaller "
      "TargetEdgeLength or GapSize.");
  }
  if (report.creases.missing > std::max(edgeLength, MissingPart * report.creases.length))
  {
    say("Of the target's creases, ", report.creases.length, " long in all, ",
      report.creases.missing, " are not on edges of the result, some at (",
      report.creases.place.transpose(),
      "): other parts are too near, or the result does not lie on the target there; use a smaller "
      "TargetEdgeLength, and no OffsetDistance.");
  }
  return sentences;
}

} // namespace evolving
