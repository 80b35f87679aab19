// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LostTopology/MedialProbes.h"

#include "Remeshing/TargetSamples.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace evolving
{

namespace
{

/// Of the width: one half is what a slit's middle has, a quarter that of a square hole half-way
/// from its axis to a wall.
constexpr double LeastClearance = 0.25;

double longestEdge(const Triangle& triangle)
{
  const auto& [a, b, c] = triangle.corners;
  return std::sqrt(
    std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() }));
}

std::optional<MedialProbe> probeFrom(
  const AABBTree& surface, Index triangle, const Vec3& point, ProbeSide side)
{
  const Vec3 normal = surface.triangle(triangle).doubleAreaNormal().stableNormalized();
  const Vec3 direction = side == ProbeSide::Front ? normal : Vec3(-normal);
  for (const RayHit& hit : surface.hits(Ray(point, direction)))
  {
    if (hit.triangle != triangle)
    {
      const MedialProbe probe{ triangle, hit.triangle, point, point + hit.parameter * direction };
      // Out of the solid a ray comes from behind; what else it meets is next to it by rounding.
      const bool isOtherSide = hit.isFromBehind == (side == ProbeSide::Behind);
      return isOtherSide ? std::optional<MedialProbe>(probe) : std::nullopt;
    }
  }
  return std::nullopt;
}

} // namespace

bool isWidth(const AABBTree& surface, const MedialProbe& probe)
{
  const double least = LeastClearance * probe.width();
  return surface.closest(probe.middle(), least * least).triangle == NoIndex;
}

ProbePlaces probePlaces(const SurfaceMesh& surface, double spacing)
{
  ProbePlaces places;
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const Triangle triangle = triangleOf(surface, face);
    const double area = 0.5 * triangle.doubleAreaNormal().norm();
    const double wanted = std::max(1.0, std::round(area / (spacing * spacing)));
    const GridIndex count = isDegenerate(triangle) ? 0 : static_cast<GridIndex>(wanted);
    for (GridIndex i = 0; i < count; ++i)
    {
      places.triangles.push_back(face);
      places.points.push_back(sampleOf(triangle, i));
    }
    // In a triangle that is long and thin they lie one behind the other.
    places.reach.push_back(std::max(std::sqrt(area / wanted), longestEdge(triangle) / wanted));
  }
  return places;
}

std::vector<MedialProbe> medialProbes(
  const AABBTree& surface, const ProbePlaces& places, ProbeSide side, const Execution& execution)
{
  std::vector<std::optional<MedialProbe>> found(places.points.size());
  execution.forRangeReporting(static_cast<std::int64_t>(found.size()), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        found[i] = probeFrom(surface, places.triangles[i], places.points[i], side);
      }
    });
  std::vector<MedialProbe> probes;
  for (const std::optional<MedialProbe>& probe : found)
  {
    if (probe)
    {
      probes.push_back(*probe);
    }
  }
  return probes;
}

} // namespace evolving
