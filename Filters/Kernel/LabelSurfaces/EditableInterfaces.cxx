// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/EditableInterfaces.h"

#include <algorithm>
#include <iterator>

namespace evolving
{

namespace
{

EditableInterfaces::Corners reversed(const EditableInterfaces::Corners& corners)
{
  return { corners[0], corners[2], corners[1] };
}

} // namespace

EditableInterfaces::EditableInterfaces(const InterfaceNet& net, const InterfaceTriangles& triangles,
  const std::vector<Vec3>& places, const Part& part)
{
  std::vector<Index> numbers(places.size(), NoIndex);
  for (Index triangle = 0; triangle < triangles.count(); ++triangle)
  {
    const Index* v = &triangles.corners[at(3 * triangle)];
    if (std::none_of(v, v + 3, [&](Index i) { return part.isChosen[at(i)] != 0; }))
    {
      continue;
    }
    Corners corners{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      Index& number = numbers[at(v[k])];
      if (number == NoIndex)
      {
        number = this->vertexCount();
        this->Numbers.push_back(v[k]);
        this->Places.push_back(places[at(v[k])]);
        this->Kinds.push_back(net.kinds[at(v[k])]);
        this->Free.push_back(part.isChosen[at(v[k])] != 0 && part.isFree[at(v[k])] != 0 ? 1 : 0);
        this->Pinched.push_back(part.isPinched[at(v[k])]);
        this->Stars.emplace_back();
      }
      corners[k] = number;
      this->Stars[at(number)].push_back(this->triangleCount());
    }
    const NetQuad& quad = net.quads[at(triangles.quads[at(triangle)])];
    this->Sheets.push_back(sortedSides(quad));
    this->Turned.push_back(quad.sides != this->Sheets.back() ? 1 : 0);
    this->Triangles.push_back(this->Turned.back() != 0 ? reversed(corners) : corners);
    this->Sources.push_back(triangle);
  }
  this->Alive.assign(this->Triangles.size(), 1);
}

std::vector<Index> EditableInterfaces::trianglesAt(Index a, Index b) const
{
  std::vector<Index> found;
  std::copy_if(this->star(a).begin(), this->star(a).end(), std::back_inserter(found),
    [&](Index triangle) { return hasCorner(this->corners(triangle), b); });
  return found;
}

std::vector<Index> EditableInterfaces::neighborsIn(
  const std::vector<Index>& triangles, Index vertex) const
{
  std::vector<Index> found;
  for (const Index triangle : triangles)
  {
    std::copy_if(this->corners(triangle).begin(), this->corners(triangle).end(),
      std::back_inserter(found), [vertex](Index corner) { return corner != vertex; });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<Index> EditableInterfaces::neighbors(Index vertex) const
{
  return this->neighborsIn(this->star(vertex), vertex);
}

bool EditableInterfaces::areOneSheet(const std::vector<Index>& triangles) const
{
  return triangles.size() == 2 && this->sheet(triangles[0]) == this->sheet(triangles[1]);
}

std::vector<Index> EditableInterfaces::curveNeighbors(Index vertex) const
{
  std::vector<Index> found;
  for (const Index other : this->neighbors(vertex))
  {
    const bool isOfCurve = this->kind(other) != VertexKind::Sheet &&
      !this->areOneSheet(this->trianglesAt(vertex, other));
    if (isOfCurve)
    {
      found.push_back(other);
    }
  }
  return found;
}

void EditableInterfaces::writeTo(InterfaceTriangles& triangles, std::vector<Vec3>& places) const
{
  for (Index vertex = 0; vertex < this->vertexCount(); ++vertex)
  {
    if (this->isFree(vertex))
    {
      places[at(this->netVertex(vertex))] = this->place(vertex);
    }
  }
  std::vector<char> stays(triangles.quads.size(), 1);
  for (Index triangle = 0; triangle < this->triangleCount(); ++triangle)
  {
    const Index source = this->Sources[at(triangle)];
    stays[at(source)] = this->Alive[at(triangle)];
    const Corners& own = this->corners(triangle);
    const Corners corners = this->Turned[at(triangle)] != 0 ? reversed(own) : own;
    for (std::size_t k = 0; k < 3; ++k)
    {
      triangles.corners[at(3 * source) + k] = this->netVertex(corners[k]);
    }
  }
  Index count = 0;
  for (Index triangle = 0; triangle < triangles.count(); ++triangle)
  {
    if (stays[at(triangle)] != 0)
    {
      const auto corners = triangles.corners.begin() + 3 * triangle;
      std::copy(corners, corners + 3, triangles.corners.begin() + 3 * count);
      triangles.quads[at(count)] = triangles.quads[at(triangle)];
      ++count;
    }
  }
  triangles.corners.resize(at(3 * count));
  triangles.quads.resize(at(count));
}

} // namespace evolving
