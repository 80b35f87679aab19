// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/SurfaceCurves.h"

#include "Mesh/Angles.h"
#include "ParallelLoops.h"
#include "Redistribution/CurveEdges.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Two neighbours that move towards each other by this part of their distance do not meet.
constexpr double LargestPartOfGap = 0.4;

bool turnsAt(
  const SurfaceMesh& mesh, const std::vector<Index>& neighbours, Index vertex, double cornerAngle)
{
  const Vec3& point = mesh.points[at(vertex)];
  const Vec3 in = point - mesh.points[at(neighbours[0])];
  const Vec3 out = mesh.points[at(neighbours[1])] - point;
  return angleBetween(in, out) > cornerAngle * RadiansPerDegree;
}

} // namespace

SurfaceCurves::SurfaceCurves(
  const SurfaceMesh& mesh, const MeshTopology& topology, double creaseAngle, double cornerAngle)
  : Roles(mesh.points.size(), 0)
  , Start(mesh.points.size(), 0.0)
{
  const std::vector<std::vector<Index>> neighbours = curveNeighbours(mesh, topology, creaseAngle);
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    const std::vector<Index>& ends = neighbours[at(v)];
    if (!ends.empty())
    {
      this->Roles[at(v)] = ends.size() != 2 || turnsAt(mesh, ends, v, cornerAngle) ? 2 : 1;
    }
  }
  this->trace(mesh, neighbours);
  this->measure(mesh);
}

void SurfaceCurves::trace(
  const SurfaceMesh& mesh, const std::vector<std::vector<Index>>& neighbours)
{
  std::vector<char> traced(mesh.points.size(), 0); // only vertices that are no corners
  // Walks from `from` over `to` to the next corner, or round to `from`.
  const auto walk = [&](Index from, Index to)
  {
    VertexChain chain;
    chain.vertices = { from };
    while (!this->isCorner(to) && to != from)
    {
      traced[at(to)] = 1;
      const std::vector<Index>& ends = neighbours[at(to)];
      const Index next = ends[0] == chain.vertices.back() ? ends[1] : ends[0];
      chain.vertices.push_back(to);
      to = next;
    }
    chain.isClosed = !this->isCorner(to);
    if (!chain.isClosed)
    {
      chain.vertices.push_back(to);
    }
    this->Chains.push_back(std::move(chain));
  };
  for (Index corner = 0; corner < mesh.vertexCount(); ++corner)
  {
    for (const Index to : neighbours[at(corner)])
    {
      // A curve of one edge is met from both ends, a longer one is marked.
      if (this->isCorner(corner) && (this->isCorner(to) ? corner < to : !traced[at(to)]))
      {
        walk(corner, to);
      }
    }
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v)
  {
    if (this->isOnCurve(v) && !this->isCorner(v) && !traced[at(v)])
    {
      traced[at(v)] = 1;
      walk(v, neighbours[at(v)].back());
    }
  }
}

void SurfaceCurves::measure(const SurfaceMesh& mesh)
{
  for (const VertexChain& chain : this->Chains)
  {
    std::vector<Vec3> polyline;
    std::vector<double> arcLengths(1, 0.0);
    for (Index k = 0; k <= chain.edgeCount(); ++k)
    {
      polyline.push_back(mesh.points[at(chain.vertex(k))]);
      if (k > 0)
      {
        arcLengths.push_back(arcLengths.back() + (polyline[at(k)] - polyline[at(k - 1)]).norm());
      }
      if (k < chain.size() && !this->isCorner(chain.vertex(k)))
      {
        this->Start[at(chain.vertex(k))] = arcLengths.back();
      }
    }
    this->Polylines.push_back(std::move(polyline));
    this->ArcLengths.push_back(std::move(arcLengths));
  }
}

Vec3 SurfaceCurves::pointAt(std::size_t chain, double position) const
{
  const std::vector<double>& arc = this->ArcLengths[chain];
  const std::vector<Vec3>& polyline = this->Polylines[chain];
  const double length = arc.back();
  double s = std::clamp(position, 0.0, length);
  if (this->Chains[chain].isClosed && length > 0.0)
  {
    s = std::clamp(position - std::floor(position / length) * length, 0.0, length);
  }
  const auto after = std::upper_bound(arc.begin() + 1, arc.end() - 1, s);
  const auto k = static_cast<std::size_t>(after - arc.begin());
  const double segment = arc[k] - arc[k - 1];
  const double fraction = segment > 0.0 ? (s - arc[k - 1]) / segment : 0.0;
  return polyline[k - 1] + fraction * (polyline[k] - polyline[k - 1]);
}

std::vector<Vec3> SurfaceCurves::tangents(const std::vector<Vec3>& points) const
{
  std::vector<Vec3> tangents(points.size(), Vec3::Zero());
  for (const VertexChain& chain : this->Chains)
  {
    for (Index k = 0; k < chain.size(); ++k)
    {
      const Index v = chain.vertex(k);
      if (!this->isCorner(v))
      {
        tangents[at(v)] =
          (points[at(chain.vertex(k + 1))] - points[at(chain.vertex(k - 1))]).normalized();
      }
    }
  }
  return tangents;
}

std::vector<double> SurfaceCurves::positionsAlong(
  std::size_t chainNumber, const Positions& positions) const
{
  const VertexChain& chain = this->Chains[chainNumber];
  const double length = this->ArcLengths[chainNumber].back();
  std::vector<double> along;
  for (const Index v : chain.vertices)
  {
    along.push_back(positions[at(v)]);
  }
  if (chain.isClosed)
  {
    along.push_back(along.front() + length);
  }
  else
  {
    along.front() = 0.0; // corners belong to several curves
    along.back() = length;
  }
  return along;
}

void SurfaceCurves::slide(const std::vector<Vec3>& velocity, double timeStep, Positions& positions,
  std::vector<Vec3>& points) const
{
  const std::vector<Vec3> tangent = this->tangents(points);
  for (std::size_t c = 0; c < this->Chains.size(); ++c)
  {
    const VertexChain& chain = this->Chains[c];
    const std::vector<double> along = this->positionsAlong(c, positions);
    for (Index k = 0; k < chain.size(); ++k)
    {
      const Index v = chain.vertex(k);
      const double step = this->isCorner(v) ? 0.0 : timeStep * velocity[at(v)].dot(tangent[at(v)]);
      if (step != 0.0)
      {
        const double before =
          k > 0 ? along[at(k)] - along[at(k - 1)] : along.back() - along[at(chain.size() - 1)];
        const double after = along[at(k + 1)] - along[at(k)];
        positions[at(v)] += std::clamp(step, -LargestPartOfGap * before, LargestPartOfGap * after);
        points[at(v)] = this->pointAt(c, positions[at(v)]);
      }
    }
  }
}

} // namespace evolving
