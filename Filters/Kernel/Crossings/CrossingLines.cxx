// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/CrossingLines.h"

#include "Crossings/PlaneCrossing.h"

#include <algorithm>
#include <utility>

namespace evolving
{

namespace
{

/// Triangles per chunk of a loop: a large one may have thousands of segments.
constexpr std::int64_t TriangleGrain = 64;
/// Pairs of segments on triangles to look at, some seconds of them.
constexpr double MostPairs = 2e8;

/// A segment on a triangle.
struct Drawn
{
  Index segment;
  GridPoint from;
  GridPoint to;
};

/// Whether two segments have a point inside both.
bool cross(const Drawn& a, const Drawn& b)
{
  return gridOrientation(a.from, a.to, b.from) * gridOrientation(a.from, a.to, b.to) < 0 &&
    gridOrientation(b.from, b.to, a.from) * gridOrientation(b.from, b.to, a.to) < 0;
}

} // namespace

CrossingLines::CrossingLines(
  const SurfaceMesh& mesh, const std::vector<IndexPair>& pairs, const Execution& execution)
  : Mesh(mesh)
  , Edges(mesh)
  , Crossings(crossingPoints(mesh, this->Edges, pairs, execution.phase(0.0, 0.5)))
  , SegmentsOf(at(mesh.faceCount()))
  , PointsOfEdge(at(this->Edges.edgeCount()) + 1)
  , Between(this->Crossings.segments.size())
{
  this->sortSegments();
  this->sortPoints();
  this->TooMany = this->wouldBeTooMany();
  if (!this->TooMany)
  {
    this->addTriplePoints(execution.phase(0.5, 1.0));
  }
}

void CrossingLines::sortSegments()
{
  for (Index s = 0; s < static_cast<Index>(this->Crossings.segments.size()); ++s)
  {
    for (const Index triangle : this->Crossings.segments[at(s)].triangles)
    {
      this->SegmentsOf[at(triangle)].push_back(s);
    }
  }
}

void CrossingLines::sortPoints()
{
  for (const CrossingPoint& point : this->Crossings.points)
  {
    ++this->PointsOfEdge[at(point.edge) + 1];
  }
  for (std::size_t edge = 1; edge < this->PointsOfEdge.size(); ++edge)
  {
    this->PointsOfEdge[edge] += this->PointsOfEdge[edge - 1];
  }
}

bool CrossingLines::wouldBeTooMany() const
{
  double pairs = 0.0;
  for (const std::vector<Index>& segments : this->SegmentsOf)
  {
    const auto count = static_cast<double>(segments.size());
    pairs += count * count;
  }
  return pairs > MostPairs;
}

Index CrossingLines::firstTriple() const
{
  return this->firstCrossing() + static_cast<Index>(this->Crossings.points.size());
}

Index CrossingLines::pointCount() const
{
  return this->firstTriple() + static_cast<Index>(this->Triples.size());
}

const Vec3& CrossingLines::point(Index number) const
{
  if (number < this->firstCrossing())
  {
    return this->Mesh.points[at(number)];
  }
  return number < this->firstTriple()
    ? this->Crossings.points[at(number - this->firstCrossing())].point
    : this->Triples[at(number - this->firstTriple())].point;
}

Index CrossingLines::otherTriangle(Index segment, Index triangle) const
{
  const auto& [first, second] = this->trianglesOf(segment);
  return first == triangle ? second : first;
}

/// NoIndex where the two have none.
Index CrossingLines::segmentOf(Index a, Index b) const
{
  const auto& segments = this->Crossings.segments;
  const std::array<Index, 2> triangles = { std::min(a, b), std::max(a, b) };
  const auto found = std::lower_bound(segments.begin(), segments.end(), triangles,
    [](const CrossingSegment& s, const std::array<Index, 2>& t) { return s.triangles < t; });
  return found != segments.end() && found->triangles == triangles
    ? static_cast<Index>(found - segments.begin())
    : NoIndex;
}

void CrossingLines::addTriplePoints(const Execution& execution)
{
  std::vector<std::vector<TriplePoint>> found(at(this->Mesh.faceCount()));
  execution.forRangeReporting(this->Mesh.faceCount(), TriangleGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t)
      {
        found[at(t)] = this->triplePoints(t);
      }
    });
  for (const std::vector<TriplePoint>& points : found)
  {
    for (const TriplePoint& triple : points)
    {
      for (const Index segment : triple.segments)
      {
        this->Between[at(segment)].push_back(static_cast<Index>(this->Triples.size()));
      }
      this->Triples.push_back(triple);
    }
  }
}

/// Of three triangles the one with the smallest number says whether their segments meet in a point,
/// so that all three agree.
std::vector<CrossingLines::TriplePoint> CrossingLines::triplePoints(Index triangle) const
{
  std::vector<Drawn> drawn;
  for (const Index s : this->segmentsOf(triangle))
  {
    if (this->otherTriangle(s, triangle) > triangle)
    {
      const auto& [from, to] = this->endsOf(s);
      drawn.push_back({ s, this->place(triangle, from), this->place(triangle, to) });
    }
  }
  std::vector<TriplePoint> found;
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    const Index second = this->otherTriangle(drawn[i].segment, triangle);
    for (std::size_t j = i + 1; j < drawn.size(); ++j)
    {
      if (!cross(drawn[i], drawn[j]))
      {
        continue;
      }
      const Index third = this->otherTriangle(drawn[j].segment, triangle);
      const Index between = this->segmentOf(second, third);
      if (between != NoIndex)
      {
        found.push_back({ this->onSegment(drawn[i].segment, third),
          { drawn[i].segment, drawn[j].segment, between } });
      }
    }
  }
  return found;
}

/// Where a segment meets the plane of a triangle.
Vec3 CrossingLines::onSegment(Index segment, Index triangle) const
{
  const Vec3& p = this->point(this->endsOf(segment)[0]);
  const Vec3& q = this->point(this->endsOf(segment)[1]);
  return p + placeAtPlane(this->Mesh, triangle, p, q) * (q - p);
}

std::vector<Index> CrossingLines::pointsAlong(Index segment) const
{
  const auto& [from, to] = this->endsOf(segment);
  const Vec3 along = this->point(to) - this->point(from);
  std::vector<std::pair<double, Index>> inner;
  for (const Index triple : this->Between[at(segment)])
  {
    inner.emplace_back(along.dot(this->Triples[at(triple)].point), this->firstTriple() + triple);
  }
  std::sort(inner.begin(), inner.end());
  std::vector<Index> numbers = { from };
  for (const auto& [way, number] : inner)
  {
    numbers.push_back(number);
  }
  numbers.push_back(to);
  return numbers;
}

std::vector<Index> CrossingLines::pointsOnSides(Index triangle) const
{
  std::vector<Index> numbers;
  for (Index k = 0; k < 3; ++k)
  {
    const Index edge = this->Edges.edgeOf(3 * triangle + k);
    for (Index i = this->PointsOfEdge[at(edge)]; i < this->PointsOfEdge[at(edge) + 1]; ++i)
    {
      numbers.push_back(this->firstCrossing() + i);
    }
  }
  return numbers;
}

} // namespace evolving
