// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/EditableInterfaces.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace evolving
{

namespace
{

using Corners = EditableInterfaces::Corners;

/// The corner that is neither of two others.
Index opposite(const Corners& corners, Index a, Index b)
{
  return *std::find_if(
    corners.begin(), corners.end(), [a, b](Index corner) { return corner != a && corner != b; });
}

template <class Number>
std::vector<Number> sorted(std::vector<Number> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// Of sorted numbers.
template <class Number>
std::vector<Number> intersection(const std::vector<Number>& a, const std::vector<Number>& b)
{
  std::vector<Number> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common;
}

bool hasLabel(const std::array<Material, 2>& sheet, Material label)
{
  return sheet[0] == label || sheet[1] == label;
}

void remove(std::vector<Index>& numbers, Index number)
{
  numbers.erase(std::find(numbers.begin(), numbers.end(), number));
}

} // namespace

std::vector<Material> EditableInterfaces::labelsOf(const std::vector<Index>& triangles) const
{
  std::vector<Material> labels;
  for (const Index triangle : triangles)
  {
    std::copy_if(this->sheet(triangle).begin(), this->sheet(triangle).end(),
      std::back_inserter(labels), isLabel);
  }
  return sorted(std::move(labels));
}

bool EditableInterfaces::canCollapse(Index from, Index to) const
{
  const std::vector<Index> shared = this->trianglesAt(from, to);
  if (!this->isFree(from) || !this->isFree(to) || shared.size() < 2)
  {
    return false;
  }
  // A label that has both ends, but not the edge, would be pinched there.
  const std::vector<Material> labels = this->labelsOf(shared);
  return intersection(this->labelsOf(this->star(from)), this->labelsOf(this->star(to))) == labels &&
    std::all_of(labels.begin(), labels.end(),
      [&](Material label) { return this->canCollapse(from, to, label); }) &&
    !this->wouldDouble(from, to);
}

bool EditableInterfaces::isOwnEdge(Index from, Index to) const
{
  const bool isWithinSheet = this->areOneSheet(this->trianglesAt(from, to));
  return this->kind(from) != VertexKind::Node &&
    isWithinSheet == (this->kind(from) == VertexKind::Sheet);
}

std::vector<Index> EditableInterfaces::starOf(Index vertex, Material label) const
{
  std::vector<Index> found;
  std::copy_if(this->star(vertex).begin(), this->star(vertex).end(), std::back_inserter(found),
    [&](Index triangle) { return hasLabel(this->sheet(triangle), label); });
  return found;
}

/// The surface of one label passes an edge twice only if it does so at one of its ends at least.
bool EditableInterfaces::canCollapse(Index from, Index to, Material label) const
{
  const std::vector<Index> ofFrom = this->starOf(from, label);
  const std::vector<Index> ofTo = this->starOf(to, label);
  std::vector<Index> opposites;
  for (const Index triangle : ofFrom)
  {
    if (hasCorner(this->corners(triangle), to))
    {
      opposites.push_back(opposite(this->corners(triangle), from, to));
    }
  }
  const bool isPinched = this->Pinched[at(from)] != 0 || this->Pinched[at(to)] != 0;
  const bool isTwice = opposites.size() == 4 && isPinched;
  opposites = sorted(std::move(opposites));
  if (opposites.size() != (isTwice ? 4U : 2U) ||
    intersection(this->neighborsIn(ofFrom, from), this->neighborsIn(ofTo, to)) != opposites)
  {
    return false;
  }
  // Edges that become one have two triangles each; more would leave open which belong together.
  return std::all_of(opposites.begin(), opposites.end(),
    [&](Index other)
    {
      const auto isAtEdge = [&](Index triangle)
      { return hasCorner(this->corners(triangle), other); };
      return std::count_if(ofFrom.begin(), ofFrom.end(), isAtEdge) == 2 &&
        std::count_if(ofTo.begin(), ofTo.end(), isAtEdge) == 2;
    });
}

/// Would two triangles have the same corners?
bool EditableInterfaces::wouldDouble(Index from, Index to) const
{
  return std::any_of(this->star(from).begin(), this->star(from).end(),
    [&](Index triangle)
    {
      Corners corners = this->corners(triangle);
      if (hasCorner(corners, to))
      {
        return false;
      }
      std::replace(corners.begin(), corners.end(), from, to);
      return std::any_of(this->star(to).begin(), this->star(to).end(),
        [&](Index other)
        {
          return std::all_of(corners.begin(), corners.end(),
            [&](Index corner) { return hasCorner(this->corners(other), corner); });
        });
    });
}

void EditableInterfaces::collapse(Index from, Index to)
{
  for (const Index triangle : this->trianglesAt(from, to))
  {
    this->Alive[at(triangle)] = 0;
    for (const Index corner : this->corners(triangle))
    {
      remove(this->Stars[at(corner)], triangle);
    }
  }
  for (const Index triangle : this->star(from))
  {
    Corners& corners = this->Triangles[at(triangle)];
    std::replace(corners.begin(), corners.end(), from, to);
    this->Stars[at(to)].push_back(triangle);
  }
  this->Stars[at(from)].clear();
  this->Pinched[at(to)] = std::max(this->Pinched[at(to)], this->Pinched[at(from)]);
}

/// Does some label's surface pass an edge more than once?
bool EditableInterfaces::isPassedTwice(Index a, Index b) const
{
  const std::vector<Index> triangles = this->trianglesAt(a, b);
  const std::vector<Material> labels = this->labelsOf(triangles);
  return std::any_of(labels.begin(), labels.end(),
    [&](Material label)
    {
      return std::count_if(triangles.begin(), triangles.end(),
               [&](Index triangle) { return hasLabel(this->sheet(triangle), label); }) > 2;
    });
}

std::array<Index, 2> EditableInterfaces::flipEnds(Index a, Index b) const
{
  const std::vector<Index> shared = this->trianglesAt(a, b);
  constexpr std::array<Index, 2> None = { NoIndex, NoIndex };
  if (!this->areOneSheet(shared) || !this->isFree(a) || !this->isFree(b))
  {
    return None;
  }
  const std::array<Index, 2> ends = { opposite(this->corners(shared[0]), a, b),
    opposite(this->corners(shared[1]), a, b) };
  const Index known = this->isFree(ends[0]) ? 0 : 1;
  if (ends[0] == ends[1] || !this->isFree(ends[at(known)]) ||
    !this->trianglesAt(ends[at(known)], ends[at(1 - known)]).empty())
  {
    return None;
  }
  // Which triangles belong together at an edge that a surface passes twice, their voxels tell.
  const bool isTold = std::any_of(ends.begin(), ends.end(),
    [&](Index end) { return this->isPassedTwice(a, end) || this->isPassedTwice(b, end); });
  return isTold ? None : ends;
}

/// The triangles (a, b, c) and (b, a, d) become (c, d, b) and (d, c, a).
void EditableInterfaces::flip(Index a, Index b)
{
  const std::vector<Index> shared = this->trianglesAt(a, b);
  const Corners& first = this->corners(shared[0]);
  const std::array<Index, 2> ends = { opposite(first, a, b),
    opposite(this->corners(shared[1]), a, b) };
  const auto place = std::find(first.begin(), first.end(), a) - first.begin();
  const bool isForwards = first[static_cast<std::size_t>(place + 1) % 3] == b;
  const Index tail = isForwards ? a : b;
  const Index head = isForwards ? b : a;
  this->Triangles[at(shared[0])] = { ends[0], ends[1], head };
  this->Triangles[at(shared[1])] = { ends[1], ends[0], tail };
  remove(this->Stars[at(tail)], shared[0]);
  remove(this->Stars[at(head)], shared[1]);
  this->Stars[at(ends[0])].push_back(shared[1]);
  this->Stars[at(ends[1])].push_back(shared[0]);
}

} // namespace evolving
