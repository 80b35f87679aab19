// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/TriangleNeighbours.h"

#include <algorithm>
#include <numeric>

namespace evolving
{

namespace
{

std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}

/// The faces at every vertex, one vertex after the other.
struct VertexFaces
{
  explicit VertexFaces(const SurfaceMesh& mesh)
    : offsets(mesh.points.size() + 1, 0)
    , faces(mesh.cornerVertices.size())
  {
    for (const Index vertex : mesh.cornerVertices)
    {
      ++this->offsets[at(vertex) + 1];
    }
    std::partial_sum(this->offsets.begin(), this->offsets.end(), this->offsets.begin());
    std::vector<Index> place(this->offsets.begin(), this->offsets.end() - 1);
    for (Index corner = 0; corner < mesh.cornerCount(); ++corner)
    {
      this->faces[at(place[at(mesh.cornerVertices[at(corner)])]++)] = corner / 3;
    }
  }

  std::vector<Index> offsets;
  std::vector<Index> faces;
};

} // namespace

TriangleNeighbours::TriangleNeighbours(const SurfaceMesh& mesh)
{
  const VertexFaces around(mesh);
  this->Offsets.reserve(at(mesh.faceCount()) + 1);
  this->Neighbours.reserve(12 * at(mesh.faceCount())); // as many as in a regular mesh
  std::vector<Index> found;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    found.clear();
    for (Index k = 0; k < 3; ++k)
    {
      const std::size_t vertex = at(mesh.faceVertex(face, k));
      const auto first = around.faces.begin() + around.offsets[vertex];
      const auto last = around.faces.begin() + around.offsets[vertex + 1];
      if (last - first <= LargestFan)
      {
        std::copy_if(first, last, std::back_inserter(found), [face](Index f) { return f != face; });
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    this->Neighbours.insert(this->Neighbours.end(), found.begin(), found.end());
    this->Offsets.push_back(this->Neighbours.size());
  }
}

} // namespace evolving
