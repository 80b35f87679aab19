// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/TriangleEdges.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace evolving
{

namespace
{

Index startOf(const SurfaceMesh& mesh, Index corner)
{
  return mesh.cornerVertices[at(corner)];
}

Index endOf(const SurfaceMesh& mesh, Index corner)
{
  return mesh.cornerVertices[at(TriangleEdges::nextCorner(corner))];
}

/// The corners ordered by the smaller vertex of their edge: a counting sort.
std::vector<Index> sortedBySmallerVertex(const SurfaceMesh& mesh, std::vector<Index>& firstOfVertex)
{
  const auto smaller = [&mesh](Index corner)
  { return std::min(startOf(mesh, corner), endOf(mesh, corner)); };
  firstOfVertex.assign(mesh.points.size() + 1, 0);
  for (Index corner = 0; corner < mesh.cornerCount(); ++corner)
  {
    ++firstOfVertex[at(smaller(corner)) + 1];
  }
  std::partial_sum(firstOfVertex.begin(), firstOfVertex.end(), firstOfVertex.begin());
  std::vector<Index> place(firstOfVertex.begin(), firstOfVertex.end() - 1);
  std::vector<Index> corners(mesh.cornerVertices.size());
  for (Index corner = 0; corner < mesh.cornerCount(); ++corner)
  {
    corners[at(place[at(smaller(corner))]++)] = corner;
  }
  return corners;
}

} // namespace

TriangleEdges::TriangleEdges(const SurfaceMesh& mesh)
{
  std::vector<Index> firstOfVertex;
  this->Corners = sortedBySmallerVertex(mesh, firstOfVertex);
  this->EdgeOfCorner.resize(this->Corners.size());
  const auto larger = [&mesh](Index corner)
  { return std::max(startOf(mesh, corner), endOf(mesh, corner)); };
  for (std::size_t vertex = 0; vertex + 1 < firstOfVertex.size(); ++vertex)
  {
    const auto first = this->Corners.begin() + firstOfVertex[vertex];
    const auto last = this->Corners.begin() + firstOfVertex[vertex + 1];
    std::sort(first, last,
      [&larger](Index a, Index b)
      { return larger(a) != larger(b) ? larger(a) < larger(b) : a < b; });
    for (auto corner = first; corner != last; ++corner)
    {
      if (corner != first && larger(*corner) != larger(*(corner - 1)))
      {
        this->Offsets.push_back(static_cast<Index>(corner - this->Corners.begin()));
      }
      this->EdgeOfCorner[at(*corner)] = this->edgeCount();
    }
    if (first != last)
    {
      this->Offsets.push_back(static_cast<Index>(last - this->Corners.begin()));
    }
  }
}

void TriangleEdges::turn(const std::vector<char>& isTurned)
{
  for (std::size_t face = 0; face < isTurned.size(); ++face)
  {
    if (isTurned[face])
    {
      // The edges from and to the first corner; the one opposite it only runs the other way.
      std::swap(this->EdgeOfCorner[3 * face], this->EdgeOfCorner[3 * face + 2]);
    }
  }
  std::vector<Index> place(this->Offsets.begin(), this->Offsets.end() - 1);
  for (std::size_t corner = 0; corner < this->EdgeOfCorner.size(); ++corner)
  {
    this->Corners[at(place[at(this->EdgeOfCorner[corner])]++)] = static_cast<Index>(corner);
  }
}

bool TriangleEdges::runsUpwards(const SurfaceMesh& mesh, Index corner)
{
  return startOf(mesh, corner) < endOf(mesh, corner);
}

} // namespace evolving
