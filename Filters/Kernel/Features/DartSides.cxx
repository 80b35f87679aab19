// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/DartSides.h"

#include "Mesh/DisjointSets.h"

#include <algorithm>
#include <set>
#include <utility>

namespace evolving
{

namespace
{

void sortUnique(std::vector<Index>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

bool hasVertex(const TargetTriangles& target, Index edge, Index vertex)
{
  const auto [a, b] = target.edgeVertices(edge);
  return a == vertex || b == vertex;
}

/// The triangles at a vertex in groups connected there over edges that are not sharp.
std::vector<std::vector<Index>> fansAround(
  const TargetTriangles& target, const SharpEdges& sharp, Index vertex)
{
  std::set<Index> left(target.facesBegin(vertex), target.facesEnd(vertex));
  std::vector<std::vector<Index>> fans;
  while (!left.empty())
  {
    std::vector<Index> fan{ *left.begin() };
    left.erase(left.begin());
    for (std::size_t k = 0; k < fan.size(); ++k)
    {
      forEachSmoothNeighbour(target, sharp, fan[k],
        [&](Index other, Index edge)
        {
          if (hasVertex(target, edge, vertex) && left.erase(other) != 0)
          {
            fan.push_back(other);
          }
        });
    }
    fans.push_back(std::move(fan));
  }
  return fans;
}

} // namespace

DartSides::DartSides(
  const TargetTriangles& target, const SharpEdges& sharp, const TriangleLabels& patches)
  : IsSeed(static_cast<std::size_t>(target.mesh().faceCount()), 0)
  , Sets(static_cast<std::size_t>(target.mesh().faceCount()))
{
  this->findDarts(target, sharp, patches);
  this->measureDarts(target);
  for (const Index vertex : this->Vertices)
  {
    this->joinAround(target, sharp, vertex);
  }
}

void DartSides::addDart(const TargetTriangles& target, Index edge, Index left, Index right)
{
  this->Sets.separate(left, right);
  this->Seeds.insert(this->Seeds.end(), { left, right });
  const auto [from, to] = target.edgeVertices(edge);
  this->Vertices.insert(this->Vertices.end(), { from, to });
  this->Edges.push_back(edge);
}

void DartSides::measureDarts(const TargetTriangles& target)
{
  DisjointSets connected(target.mesh().points.size());
  std::vector<double> lengths(target.mesh().points.size(), 0.0);
  for (const Index edge : this->Edges)
  {
    connected.join(target.edgeVertices(edge)[0], target.edgeVertices(edge)[1]);
  }
  for (const Index edge : this->Edges)
  {
    double& length =
      lengths[static_cast<std::size_t>(connected.find(target.edgeVertices(edge)[0]))];
    length += target.edgeLength(edge);
    this->LongestDart = std::max(this->LongestDart, length);
  }
}

void DartSides::findDarts(
  const TargetTriangles& target, const SharpEdges& sharp, const TriangleLabels& patches)
{
  for (const Index edge : sharp.list())
  {
    const Index* last = target.edges().end(edge);
    for (const Index* a = target.edges().begin(edge); a != last; ++a)
    {
      for (const Index* b = a + 1; b != last; ++b)
      {
        const Index left = TargetTriangles::faceOf(*a);
        const Index right = TargetTriangles::faceOf(*b);
        if (patches[left] == patches[right])
        {
          this->addDart(target, edge, left, right);
        }
      }
    }
  }
  sortUnique(this->Seeds);
  sortUnique(this->Vertices);
  sortUnique(this->Edges);
  for (const Index seed : this->Seeds)
  {
    this->IsSeed[static_cast<std::size_t>(seed)] = 1;
  }
}

void DartSides::joinAround(const TargetTriangles& target, const SharpEdges& sharp, Index vertex)
{
  for (const std::vector<Index>& fan : fansAround(target, sharp, vertex))
  {
    Index first = NoIndex;
    for (const Index face : fan)
    {
      if (this->IsSeed[static_cast<std::size_t>(face)] != 0)
      {
        first = first == NoIndex ? face : first;
        this->Sets.join(first, face);
      }
    }
  }
}

} // namespace evolving
