// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/FeatureCurves.h"

#include "Mesh/Angles.h"

#include <algorithm>
#include <numeric>

namespace evolving
{

FeatureCurves::FeatureCurves(const TargetTriangles& target, const SharpEdges& sharp)
  : CurveOfEdge(at(target.edges().edgeCount()), NoIndex)
{
  const std::vector<Index> edges = sharp.list();
  this->sortByVertex(target, edges);
  for (Index vertex = 0; vertex < target.mesh().vertexCount(); ++vertex)
  {
    this->Roles.push_back(this->roleOf(target, vertex));
    if (this->Roles.back() == Role::Corner)
    {
      this->Corners.push_back(vertex);
    }
  }
  for (const Index corner : this->Corners)
  {
    for (Index k = this->EdgeOffsets[at(corner)]; k < this->EdgeOffsets[at(corner) + 1]; ++k)
    {
      this->trace(target, sharp, corner, this->EdgesOfVertices[at(k)]);
    }
  }
  for (const Index edge : edges) // what is left are closed curves
  {
    this->trace(target, sharp, target.edgeVertices(edge)[0], edge);
  }
}

Index FeatureCurves::valence(Index vertex) const
{
  return this->EdgeOffsets[at(vertex) + 1] - this->EdgeOffsets[at(vertex)];
}

void FeatureCurves::sortByVertex(const TargetTriangles& target, const std::vector<Index>& edges)
{
  this->EdgeOffsets.assign(at(target.mesh().vertexCount()) + 1, 0);
  for (const Index edge : edges)
  {
    for (const Index vertex : target.edgeVertices(edge))
    {
      ++this->EdgeOffsets[at(vertex) + 1];
    }
  }
  std::partial_sum(this->EdgeOffsets.begin(), this->EdgeOffsets.end(), this->EdgeOffsets.begin());
  std::vector<Index> place(this->EdgeOffsets.begin(), this->EdgeOffsets.end() - 1);
  this->EdgesOfVertices.resize(2 * edges.size());
  for (const Index edge : edges)
  {
    for (const Index vertex : target.edgeVertices(edge))
    {
      this->EdgesOfVertices[at(place[at(vertex)]++)] = edge;
    }
  }
}

FeatureCurves::Role FeatureCurves::roleOf(const TargetTriangles& target, Index vertex) const
{
  if (this->valence(vertex) != 2)
  {
    return this->valence(vertex) == 0 ? Role::None : Role::Corner;
  }
  const auto alongEdge = [&](Index k) -> Vec3
  {
    const Index edge = this->EdgesOfVertices[at(this->EdgeOffsets[at(vertex)] + k)];
    const auto [a, b] = target.edgeVertices(edge);
    return target.point(a == vertex ? b : a) - target.point(vertex);
  };
  const double turn = angleBetween(alongEdge(0), -alongEdge(1));
  return turn > CornerAngle * RadiansPerDegree ? Role::Corner : Role::Curve;
}

Index FeatureCurves::otherEdge(Index vertex, Index edge) const
{
  const Index first = this->EdgeOffsets[at(vertex)];
  const Index candidate = this->EdgesOfVertices[at(first)];
  return candidate != edge ? candidate : this->EdgesOfVertices[at(first + 1)];
}

void FeatureCurves::trace(
  const TargetTriangles& target, const SharpEdges& sharp, Index start, Index edge)
{
  if (this->CurveOfEdge[at(edge)] != NoIndex)
  {
    return;
  }
  FeatureCurve curve;
  curve.isClosed = !this->isCorner(start);
  curve.vertices.push_back(start);
  Index vertex = start;
  while (this->CurveOfEdge[at(edge)] == NoIndex)
  {
    this->CurveOfEdge[at(edge)] = static_cast<Index>(this->Curves.size());
    const auto [a, b] = target.edgeVertices(edge);
    vertex = a == vertex ? b : a;
    curve.edges.push_back(edge);
    curve.vertices.push_back(vertex);
    curve.length += target.edgeLength(edge);
    curve.fold += target.edgeLength(edge) * sharp.fold(edge);
    if (this->isCorner(vertex))
    {
      break;
    }
    edge = this->otherEdge(vertex, edge);
  }
  curve.fold /= curve.length;
  this->Curves.push_back(std::move(curve));
}

} // namespace evolving
