// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/AngleRedistribution.h"

#include "Evolution/ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

constexpr double LargestPartOfAltitude = 0.25;

/// (1 + cos theta)(a + b) of two edges; an edge without length makes no angle.
Vec3 pairTerm(const Vec3& a, const Vec3& b)
{
  const double lengths = a.norm() * b.norm();
  return lengths > 0.0 ? Vec3((1.0 + a.dot(b) / lengths) * (a + b)) : Vec3(Vec3::Zero());
}

double smallestTriangleAltitude(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double longest =
    std::sqrt(std::max({ (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() }));
  return longest > 0.0 ? (b - a).cross(c - a).norm() / longest : 0.0;
}

double weight(AngleWeighting weighting, double coVolume, double meanCoVolume,
  const std::vector<double>& distance, double distanceScale, Index vertex)
{
  switch (weighting)
  {
    case AngleWeighting::InverseArea:
      return std::min(1.0, meanCoVolume / coVolume);
    case AngleWeighting::Distance:
      return distance.empty() ? 1.0 : std::min(1.0, std::abs(distance[at(vertex)]) / distanceScale);
    default:
      return 1.0;
  }
}

} // namespace

Vec3 angleVelocity(const SurfaceMesh& mesh, const MeshTopology& topology, Index vertex, double rate)
{
  const MeshTopology::Run ring = topology.ringVertices(vertex);
  if (ring.size() == 0)
  {
    return Vec3::Zero();
  }
  const Vec3& centre = mesh.points[at(vertex)];
  const Index pairs = topology.isBoundary(vertex) ? ring.size() - 1 : ring.size();
  Vec3 sum = Vec3::Zero();
  for (Index j = 0; j < pairs; ++j)
  {
    sum += pairTerm(
      mesh.points[at(ring[j])] - centre, mesh.points[at(ring[(j + 1) % ring.size()])] - centre);
  }
  return rate / ring.size() * sum;
}

double smallestAltitude(const SurfaceMesh& mesh, const MeshTopology& topology, Index vertex)
{
  double smallest = std::numeric_limits<double>::infinity();
  const auto point = [&](Index corner) -> const Vec3&
  { return mesh.points[at(topology.vertexOf(corner))]; };
  for (const Index corner : topology.ringCorners(vertex))
  {
    smallest = std::min(smallest,
      smallestTriangleAltitude(
        point(corner), point(topology.next(corner)), point(topology.previous(corner))));
  }
  return smallest;
}

std::vector<Vec3> angleRedistribution(const SurfaceMesh& mesh, const SurfaceGeometry& geometry,
  const RedistributionOptions& options, const std::vector<double>& distance, double distanceScale,
  double timeStep, const Execution& execution)
{
  const std::vector<double>& mu = geometry.coVolumes();
  const double meanCoVolume =
    totalArea(mu, execution) / std::max(1.0, static_cast<double>(mu.size()));
  std::vector<Vec3> velocity(mesh.points.size());
  forEachIndex(execution, mesh.vertexCount(),
    [&](Index i)
    {
      const double rate = options.angle *
        weight(options.angleWeighting, mu[at(i)], meanCoVolume, distance, distanceScale, i);
      const Vec3 v = tangentialPart(
        angleVelocity(mesh, geometry.topology(), i, rate), geometry.normals()[at(i)]);
      const double farthest =
        LargestPartOfAltitude * smallestAltitude(mesh, geometry.topology(), i);
      const double length = timeStep * v.norm();
      velocity[at(i)] = length > farthest ? Vec3(farthest / length * v) : v;
    });
  return velocity;
}

} // namespace evolving
