// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/FrontContacts.h"

#include "Mesh/MeshTopology.h"
#include "Mesh/VertexNormals.h"
#include "ParallelLoops.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Sides face each other when the cosine between their normals is below this: not those of a groove
/// that opens by more than 37 degrees, which the flow can follow.
constexpr double FacingCosine = -0.8;

/// Does another side face a point on its way along a ray?
bool meetsOtherSide(const AABBTree& tree, const Ray& ray, const Vec3& normal)
{
  const std::vector<RayHit> hits = tree.hits(ray);
  return std::any_of(hits.begin(), hits.end(),
    [&](const RayHit& hit)
    {
      const Vec3 other = tree.triangle(hit.triangle).doubleAreaNormal().stableNormalized();
      const bool isAhead = hit.parameter > 0.0 && hit.parameter <= 1.0;
      return isAhead && other.dot(normal) < FacingCosine;
    });
}

} // namespace

Index keepFrontsApart(SurfaceMesh& surface, const std::vector<Vec3>& before,
  const std::vector<double>& distance, double thickness, const Execution& execution)
{
  const bool isNear = std::all_of(
    distance.begin(), distance.end(), [thickness](double d) { return std::abs(d) <= thickness; });
  if (isNear)
  {
    return 0;
  }
  const AABBTree tree(surface, execution);
  const std::vector<Vec3> normals = angleWeightedNormals(surface, MeshTopology(surface), execution);
  std::vector<char> isContact(surface.points.size(), 0);
  execution.forRange(surface.vertexCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto v = static_cast<Index>(begin); v < static_cast<Index>(end); ++v)
      {
        const Vec3& normal = normals[at(v)];
        const Ray inwards{ surface.points[at(v)], -thickness * normal };
        const bool isFar = std::abs(distance[at(v)]) > thickness;
        isContact[at(v)] = isFar && meetsOtherSide(tree, inwards, normal) ? 1 : 0;
      }
    });
  for (Index v = 0; v < surface.vertexCount(); ++v)
  {
    if (isContact[at(v)] != 0)
    {
      Vec3& point = surface.points[at(v)];
      const double inwards = std::min(0.0, (point - before[at(v)]).dot(normals[at(v)]));
      point -= inwards * normals[at(v)];
    }
  }
  return static_cast<Index>(std::count(isContact.begin(), isContact.end(), 1));
}

} // namespace evolving
