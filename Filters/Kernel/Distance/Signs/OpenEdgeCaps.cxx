// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/OpenEdgeCaps.h"

#include <algorithm>
#include <utility>

namespace evolving
{

namespace
{

/// A triangle over points [first, last] of a loop, against its direction, and over both halves.
void addCap(const std::vector<Index>& loop, std::size_t first, std::size_t last,
  std::vector<std::array<Index, 3>>& caps)
{
  if (last - first < 2)
  {
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  const Index a = loop[first];
  const Index b = loop[last % loop.size()];
  if (a != b) // the first two halves of a loop have one chord
  {
    caps.push_back({ b, loop[middle], a });
  }
  addCap(loop, first, middle, caps);
  addCap(loop, middle, last, caps);
}

/// Goes along edges until a point comes again, and cuts off the loop then.
class LoopCutter
{
public:
  LoopCutter(std::vector<std::array<Index, 2>> edges, Index pointCount)
    : Edges(std::move(edges))
    , Next(at(pointCount) + 1, 0)
    , PlaceOnWay(at(pointCount), NoIndex)
  {
    std::sort(this->Edges.begin(), this->Edges.end());
    std::size_t edge = 0;
    for (std::size_t point = 0; point < this->Next.size(); ++point)
    {
      this->Next[point] = edge;
      while (edge < this->Edges.size() && at(this->Edges[edge][0]) == point)
      {
        ++edge;
      }
    }
    this->End.assign(this->Next.begin() + 1, this->Next.end());
  }

  std::vector<std::array<Index, 3>> caps()
  {
    for (const std::array<Index, 2>& edge : this->Edges)
    {
      this->walkFrom(edge[0]);
    }
    return std::move(this->Caps);
  }

private:
  /// As many open edges end at a point as begin, so that the way ends where it began.
  void walkFrom(Index start)
  {
    this->enter(start);
    for (Index here = start; this->Next[at(here)] < this->End[at(here)]; here = this->Way.back())
    {
      const Index to = this->Edges[this->Next[at(here)]++][1];
      if (this->PlaceOnWay[at(to)] == NoIndex)
      {
        this->enter(to);
      }
      else
      {
        this->cutOff(at(this->PlaceOnWay[at(to)]));
      }
    }
    this->PlaceOnWay[at(start)] = NoIndex;
    this->Way.clear();
  }
  void enter(Index point)
  {
    this->PlaceOnWay[at(point)] = static_cast<Index>(this->Way.size());
    this->Way.push_back(point);
  }
  /// The loop from a place on the way to its end; its first point stays.
  void cutOff(std::size_t place)
  {
    const std::vector<Index> loop(
      this->Way.begin() + static_cast<std::ptrdiff_t>(place), this->Way.end());
    addCap(loop, 0, loop.size(), this->Caps);
    for (; this->Way.size() > place + 1; this->Way.pop_back())
    {
      this->PlaceOnWay[at(this->Way.back())] = NoIndex;
    }
  }

  std::vector<std::array<Index, 2>> Edges; ///< by where they begin
  std::vector<std::size_t> Next;           ///< the first edge from each point not gone along
  std::vector<std::size_t> End;            ///< of the edges from each point
  std::vector<Index> Way;
  std::vector<Index> PlaceOnWay; ///< NoIndex beside it
  std::vector<std::array<Index, 3>> Caps;
};

} // namespace

std::vector<std::array<Index, 3>> capsOver(
  const std::vector<std::array<Index, 2>>& openEdges, Index pointCount)
{
  return LoopCutter(openEdges, pointCount).caps();
}

} // namespace evolving
