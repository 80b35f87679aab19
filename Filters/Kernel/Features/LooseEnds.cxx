// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/LooseEnds.h"

#include "Mesh/Angles.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// In degrees: what turns more from edge to edge is no continuation.
constexpr double LargestTurn = 60.0;
/// A crease that does not come to another within so many edges has faded.
constexpr std::size_t MostEdges = 20;

class LooseEnds
{
public:
  LooseEnds(const TargetTriangles& target, SharpEdges& sharp, double weakest)
    : Target(target)
    , Sharp(sharp)
    , Weakest(weakest)
    , EdgesOf(target.mesh().points.size())
    , SharpCount(target.mesh().points.size(), 0)
  {
    for (Index edge = 0; edge < target.edges().edgeCount(); ++edge)
    {
      for (const Index v : target.edgeVertices(edge))
      {
        this->EdgesOf[at(v)].push_back(edge);
        this->SharpCount[at(v)] += sharp.isSharp(edge) ? 1 : 0;
      }
    }
  }

  void followAll()
  {
    for (Index v = 0; v < this->Target.mesh().vertexCount(); ++v)
    {
      if (this->SharpCount[at(v)] == 1)
      {
        this->take(this->pathFrom(v));
      }
    }
  }

private:
  Index sharpEdgeAt(Index v) const
  {
    const std::vector<Index>& edges = this->EdgesOf[at(v)];
    return *std::find_if(
      edges.begin(), edges.end(), [this](Index edge) { return this->Sharp.isSharp(edge); });
  }

  Index otherEnd(Index edge, Index v) const
  {
    const auto [a, b] = this->Target.edgeVertices(edge);
    return a == v ? b : a;
  }

  Vec3 wayFrom(Index v, Index edge) const
  {
    return this->Target.point(this->otherEnd(edge, v)) - this->Target.point(v);
  }

  /// The strongest of the edges that go on from another; NoIndex where none does.
  Index continuation(Index v, Index last) const
  {
    const Vec3 onwards = -this->wayFrom(v, last);
    Index best = NoIndex;
    for (const Index edge : this->EdgesOf[at(v)])
    {
      if (edge != last && this->Target.edges().faceCount(edge) == 2 &&
        this->Sharp.foldsBeyond(edge, this->Weakest) &&
        angleBetween(onwards, this->wayFrom(v, edge)) < LargestTurn * RadiansPerDegree &&
        (best == NoIndex || this->Sharp.fold(edge) > this->Sharp.fold(best)))
      {
        best = edge;
      }
    }
    return best;
  }

  /// From a loose end to another sharp edge; none where it comes to no such.
  std::vector<Index> pathFrom(Index v) const
  {
    std::vector<Index> path;
    Index edge = this->sharpEdgeAt(v);
    while (path.size() < MostEdges && (edge = this->continuation(v, edge)) != NoIndex)
    {
      path.push_back(edge);
      v = this->otherEnd(edge, v);
      if (this->SharpCount[at(v)] > 0)
      {
        return path;
      }
    }
    return {};
  }

  void take(const std::vector<Index>& path)
  {
    for (const Index edge : path)
    {
      this->Sharp.takeIn(edge);
      for (const Index v : this->Target.edgeVertices(edge))
      {
        ++this->SharpCount[at(v)];
      }
    }
  }

  const TargetTriangles& Target;
  SharpEdges& Sharp;
  double Weakest;
  std::vector<std::vector<Index>> EdgesOf; ///< of each vertex
  std::vector<int> SharpCount;             ///< of each vertex
};

} // namespace

void followLooseEnds(const TargetTriangles& target, SharpEdges& sharp, double weakest)
{
  LooseEnds(target, sharp, weakest).followAll();
}

} // namespace evolving
