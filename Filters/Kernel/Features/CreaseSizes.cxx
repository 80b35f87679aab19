// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CreaseSizes.h"

#include "Features/CurveProximity.h"
#include "Features/FeatureCurves.h"
#include "Mesh/Angles.h"
#include "Mesh/SurfaceMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

constexpr double MostSamples = 1e4; ///< on one edge
/// Bends that ask for less than this part of the smallest size cannot be followed anyway.
constexpr double LeastFollowed = 0.5;

/// The points of a curve, walked along in either direction, round and round where it is closed.
class CurveWalk
{
public:
  CurveWalk(const TargetTriangles& target, const FeatureCurve& curve)
    : Target(target)
    , Curve(curve)
  {
  }

  Index count() const { return static_cast<Index>(this->Curve.vertices.size()); }
  const Vec3& point(Index i) const { return this->Target.point(this->Curve.vertices[at(i)]); }

  /// From a vertex to the next one that is not nearer than a distance; zero before that at an end.
  Vec3 chord(Index from, Index step, double distance) const
  {
    Index i = from;
    for (Index steps = 1; steps < this->count(); ++steps)
    {
      i += step;
      if (this->Curve.isClosed)
      {
        i = (i + this->count() - 1) % (this->count() - 1); // the last vertex is the first
      }
      else if (i < 0 || i >= this->count())
      {
        break;
      }
      const Vec3 way = this->point(i) - this->point(from);
      if (way.squaredNorm() >= distance * distance)
      {
        return way;
      }
    }
    return Vec3::Zero();
  }

private:
  const TargetTriangles& Target;
  const FeatureCurve& Curve;
};

/// At each vertex of a curve, 1/length, of the circle through points at a distance at least; 0
/// where the curve ends before.
std::vector<double> curvatures(const CurveWalk& walk, double distance)
{
  std::vector<double> values(at(walk.count()), 0.0);
  for (Index i = 0; i < walk.count(); ++i)
  {
    const Vec3 onwards = walk.chord(i, 1, distance);
    const Vec3 back = walk.chord(i, -1, distance);
    if (onwards != Vec3::Zero() && back != Vec3::Zero())
    {
      const double turn = Pi - angleBetween(onwards, back);
      values[at(i)] = 2.0 * turn / (onwards.norm() + back.norm());
    }
  }
  return values;
}

/// Points along creases with the sizes that are allowed there.
struct SizedSamples
{
  SurfaceMesh points; ///< triangles of three equal corners
  std::vector<double> sizes;

  void add(const Vec3& point, double size)
  {
    const Index p = this->points.addPoint(point);
    this->points.addFace({ p, p, p });
    this->sizes.push_back(size);
  }
};

class Sampling
{
public:
  Sampling(const TargetTriangles& target, const SharpEdges& creases, const CreaseSizing& sizing)
    : Target(target)
    , Creases(creases)
    , Sizing(sizing)
    , Proximity(target, creases)
  {
  }

  SizedSamples run(const Execution& execution)
  {
    for (const FeatureCurve& curve : this->Proximity.network().curves())
    {
      execution.report(0.0);
      this->sample(curve);
    }
    this->sampleBends();
    return std::move(this->Samples);
  }

private:
  void sample(const FeatureCurve& curve)
  {
    const CurveWalk walk(this->Target, curve);
    const std::vector<double> bends = curvatures(walk, this->Sizing.smallest);
    for (std::size_t e = 0; e < curve.edges.size(); ++e)
    {
      const double bend = std::max(bends[e], bends[e + 1]);
      this->sampleAlong(walk.point(static_cast<Index>(e)), walk.point(static_cast<Index>(e) + 1),
        [&](const Vec3& point) { return this->sizeAt(curve.edges[e], point, bend); });
    }
  }

  double sizeAt(Index edge, const Vec3& point, double bend) const
  {
    const double ofBend =
      bend > 0.0 ? this->Sizing.turn / bend : std::numeric_limits<double>::infinity();
    const double reach = this->Sizing.across * this->Sizing.largest;
    const double between =
      this->Proximity.distanceToOther(edge, point, reach) / this->Sizing.across;
    return std::clamp(std::min(ofBend, between), this->Sizing.smallest, this->Sizing.largest);
  }

  /// Where faces bend without a crease, so that facets of larger elements would show.
  void sampleBends()
  {
    for (Index edge = 0; edge < this->Target.edges().edgeCount(); ++edge)
    {
      const double size = this->Creases.isSharp(edge) ? 0.0 : this->sizeOfBend(edge);
      if (size >= LeastFollowed * this->Sizing.smallest && size < this->Sizing.largest)
      {
        const auto [a, b] = this->Target.edgeVertices(edge);
        this->sampleAlong(this->Target.point(a), this->Target.point(b),
          [&](const Vec3&) { return std::max(size, this->Sizing.smallest); });
      }
    }
  }

  /// That turns as much as the two faces of an edge do over the width of these.
  double sizeOfBend(Index edge) const
  {
    const TriangleEdges& edges = this->Target.edges();
    const double fold = this->Creases.fold(edge) * RadiansPerDegree;
    if (edges.faceCount(edge) != 2 || fold == 0.0)
    {
      return 0.0;
    }
    const SurfaceMesh& mesh = this->Target.mesh();
    double area = 0.0;
    std::for_each(edges.begin(edge), edges.end(edge),
      [&](Index corner) { area += faceVectorArea(mesh, TargetTriangles::faceOf(corner)).norm(); });
    const double width = area / this->Target.edgeLength(edge); // mean of both altitudes
    return this->Sizing.turn * width / fold;
  }

  template <class SizeAt>
  void sampleAlong(const Vec3& from, const Vec3& to, const SizeAt& sizeAt)
  {
    const double steps = std::ceil((to - from).norm() / this->Sizing.step);
    const int count = static_cast<int>(std::clamp(steps, 1.0, MostSamples));
    for (int k = 0; k < count; ++k)
    {
      const Vec3 point = from + (k + 0.5) / count * (to - from);
      this->Samples.add(point, sizeAt(point));
    }
  }

  const TargetTriangles& Target;
  const SharpEdges& Creases;
  const CreaseSizing& Sizing;
  CurveProximity Proximity;
  SizedSamples Samples;
};

} // namespace

CreaseSizes::CreaseSizes(const TargetTriangles& target, const SharpEdges& creases,
  const CreaseSizing& sizing, const Execution& execution)
  : Sizing(sizing)
  , Smallest(sizing.largest)
{
  SizedSamples samples = Sampling(target, creases, sizing).run(execution);
  for (const double size : samples.sizes)
  {
    this->Smallest = std::min(this->Smallest, size);
  }
  this->Sizes = std::make_shared<const std::vector<double>>(std::move(samples.sizes));
  this->Samples = std::make_shared<const AABBTree>(samples.points, execution.phase(0.0, 0.0));
}

CreaseSizes CreaseSizes::withLargest(double largest) const
{
  CreaseSizes sizes = *this;
  sizes.Sizing.largest = std::min(this->Sizing.largest, largest);
  return sizes;
}

double CreaseSizes::at(const Vec3& point) const
{
  const ClosestTriangle closest = this->Samples->closest(point);
  if (closest.triangle == NoIndex)
  {
    return this->Sizing.largest;
  }
  const double away =
    std::max(0.0, std::sqrt(closest.at.squaredDistance) - 0.5 * this->Sizing.step);
  return std::min(this->Sizing.largest,
    (*this->Sizes)[evolving::at(closest.triangle)] + this->Sizing.growth * away);
}

} // namespace evolving
