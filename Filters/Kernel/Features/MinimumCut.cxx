// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/MinimumCut.h"

#include <algorithm>
#include <limits>

namespace evolving
{

namespace
{

constexpr double Rounding = 1e-12; ///< capacity left by rounding, over the largest one

} // namespace

MinimumCut::MinimumCut(Index nodes)
  : FirstArc(at(nodes), NoIndex)
{
}

void MinimumCut::addEdge(Index a, Index b, double capacity)
{
  const auto arc = static_cast<Index>(this->Arcs.size());
  this->Arcs.push_back({ b, this->FirstArc[at(a)], capacity });
  this->Arcs.push_back({ a, this->FirstArc[at(b)], capacity });
  this->FirstArc[at(a)] = arc;
  this->FirstArc[at(b)] = arc + 1;
  this->Negligible = std::max(this->Negligible, Rounding * capacity);
}

std::vector<char> MinimumCut::sourceSide(Index source, Index sink)
{
  for (this->findLevels(source, sink); this->Levels[at(sink)] != NoIndex;
       this->findLevels(source, sink))
  {
    this->CurrentArc = this->FirstArc;
    while (this->augment(source, sink))
    {
    }
  }
  std::vector<char> side(this->FirstArc.size());
  std::transform(this->Levels.begin(), this->Levels.end(), side.begin(),
    [](Index level) { return level != NoIndex; });
  return side;
}

void MinimumCut::findLevels(Index source, Index sink)
{
  this->Levels.assign(this->FirstArc.size(), NoIndex);
  this->Levels[at(source)] = 0;
  std::vector<Index> reached{ source };
  for (std::size_t k = 0; k < reached.size() && this->Levels[at(sink)] == NoIndex; ++k)
  {
    const Index node = reached[k];
    for (Index arc = this->FirstArc[at(node)]; arc != NoIndex; arc = this->Arcs[at(arc)].next)
    {
      const Index to = this->Arcs[at(arc)].to;
      if (this->isOpen(arc) && this->Levels[at(to)] == NoIndex)
      {
        this->Levels[at(to)] = this->Levels[at(node)] + 1;
        reached.push_back(to);
      }
    }
  }
}

bool MinimumCut::leadsOn(Index node, Index arc, Index sink) const
{
  const Index to = this->Arcs[at(arc)].to;
  return this->isOpen(arc) && this->Levels[at(to)] == this->Levels[at(node)] + 1 &&
    (to == sink || this->Levels[at(to)] < this->Levels[at(sink)]);
}

bool MinimumCut::augment(Index source, Index sink)
{
  std::vector<Index> way; // arcs
  Index node = source;
  while (node != sink)
  {
    Index& arc = this->CurrentArc[at(node)];
    while (arc != NoIndex && !this->leadsOn(node, arc, sink))
    {
      arc = this->Arcs[at(arc)].next;
    }
    if (arc != NoIndex)
    {
      way.push_back(arc);
      node = this->Arcs[at(arc)].to;
      continue;
    }
    if (way.empty())
    {
      return false;
    }
    // A dead end: one step back, never here again.
    node = this->Arcs[at(way.back() ^ 1)].to;
    this->CurrentArc[at(node)] = this->Arcs[at(way.back())].next;
    way.pop_back();
  }
  double amount = std::numeric_limits<double>::infinity();
  for (const Index arc : way)
  {
    amount = std::min(amount, this->Arcs[at(arc)].capacity);
  }
  for (const Index arc : way)
  {
    this->Arcs[at(arc)].capacity -= amount;
    this->Arcs[at(arc ^ 1)].capacity += amount;
  }
  return true;
}

} // namespace evolving
