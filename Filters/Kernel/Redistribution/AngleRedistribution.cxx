// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/AngleRedistribution.h"

#include "Operators/ElementShape.h"
#include "ParallelLoops.h"

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

/// Tangential, and no farther in a step than a part of the smallest altitude.
Vec3 limitedAngleVelocity(const SurfaceMesh& mesh, const SurfaceGeometry& geometry, Index vertex,
  double rate, double timeStep)
{
  const MeshTopology& topology = geometry.topology();
  const Vec3 v =
    tangentialPart(angleVelocity(mesh, topology, vertex, rate), geometry.normals()[at(vertex)]);
  const double farthest = LargestPartOfAltitude * smallestAltitude(mesh, topology, vertex);
  const double length = timeStep * v.norm();
  return length > farthest ? Vec3(farthest / length * v) : v;
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
  const std::vector<Vec3>& tangents, const RedistributionOptions& options,
  const std::vector<double>& distance, double distanceScale, double timeStep,
  const Execution& execution)
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
      velocity[at(i)] = options.angleMethod == AngleMethod::Shape
        ? Vec3(rate *
            bestShapeMove(mesh, geometry.topology(), i, geometry.normals()[at(i)], tangents[at(i)]))
        : limitedAngleVelocity(mesh, geometry, i, rate, timeStep);
    });
  return velocity;
}

} // namespace evolving
