// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/CurvatureLife.h"

#include "Mesh/Angles.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// Of its life: a sphere then has 0.71 of its radius, the bunny no ears any more.
constexpr double LifeShown = 0.5;
/// Of longestLife(): a plate a thousand times as wide as thick. What is thinner, as a sheet with
/// two sides at the same place, has no volume that could say how long it lives.
constexpr double ShortestLife = 1e-3;

/// What of a component says how long it lives.
struct Extent
{
  double boundary = 0.0; ///< its length
  double area = 0.0;
  double volume = 0.0;
  double curvature = 0.0; ///< integral of H
};

Vec3 edgeOf(const SurfaceMesh& surface, const MeshTopology& topology, Index corner)
{
  return surface.points[at(topology.vertexOf(topology.next(corner)))] -
    surface.points[at(topology.vertexOf(corner))];
}

/// The part of an edge in the integral of H: its length times the angle between its faces, as if it
/// were rounded off.
double edgeCurvature(const SurfaceMesh& surface, const MeshTopology& topology, Index corner)
{
  const Vec3 edge = edgeOf(surface, topology, corner);
  const Vec3 left = faceVectorArea(surface, topology.faceOf(corner));
  const Vec3 right = faceVectorArea(surface, topology.faceOf(topology.opposite(corner)));
  // The cross product runs along the edge, with it where the edge is convex.
  const double sine = left.cross(right).dot(edge.normalized());
  return edge.norm() * std::atan2(sine, left.dot(right));
}

std::vector<Extent> extents(const SurfaceMesh& surface, const MeshTopology& topology)
{
  const Vec3 center = boundingBox(surface).center();
  std::vector<Extent> ofComponents(at(topology.componentCount()));
  const auto componentOf = [&](Index vertex) -> Extent&
  { return ofComponents[at(topology.componentOfVertex()[at(vertex)])]; };
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const Vec3 area = faceVectorArea(surface, face);
    Extent& extent = componentOf(surface.faceVertex(face, 0));
    extent.area += area.norm();
    extent.volume += area.dot(surface.facePoint(face, 0) - center) / 3.0;
  }
  for (Index corner = 0; corner < topology.cornerCount(); ++corner)
  {
    Extent& extent = componentOf(topology.vertexOf(corner));
    if (topology.opposite(corner) == NoIndex)
    {
      extent.boundary += edgeOf(surface, topology, corner).norm();
    }
    else if (topology.opposite(corner) > corner)
    {
      extent.curvature += edgeCurvature(surface, topology, corner);
    }
  }
  return ofComponents;
}

double timeOf(const Extent& extent)
{
  if (extent.boundary > 0.0)
  {
    const double minimal = extent.boundary * extent.boundary / (4.0 * Pi);
    return 0.25 * std::min(extent.area, minimal) + LifeShown * longestLife(extent.area);
  }
  return LifeShown * expectedLife(extent.area, extent.volume, extent.curvature);
}

} // namespace

double longestLife(double area)
{
  return area / (16.0 * Pi);
}

double expectedLife(double area, double volume, double curvature)
{
  const double longest = longestLife(area);
  const double life = 1.5 * volume / curvature;
  return life > 0.0 && life < longest ? std::max(life, ShortestLife * longest) : longest;
}

double timeOfVisibleChange(const SurfaceMesh& surface)
{
  const MeshTopology topology(surface);
  double time = 0.0;
  for (const Extent& extent : extents(surface, topology))
  {
    time = std::max(time, timeOf(extent));
  }
  return time;
}

} // namespace evolving
