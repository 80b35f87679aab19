// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/TargetTriangles.h"

#include "Distance/DistanceTarget.h"

#include <algorithm>
#include <numeric>

namespace evolving
{

TargetTriangles::TargetTriangles(const SurfaceMesh& surface, const Execution& execution)
  : Mesh(clean(surface, this->OldFace, execution))
  , Edges(this->Mesh)
{
  this->sortFacesByVertex();
}

SurfaceMesh TargetTriangles::clean(
  const SurfaceMesh& surface, std::vector<Index>& oldFace, const Execution& execution)
{
  validate(surface);
  return uniqueTriangles(surface, oldFace, execution);
}

std::array<Index, 2> TargetTriangles::edgeVertices(Index edge) const
{
  const Index corner = *this->Edges.begin(edge);
  const auto [low, high] = std::minmax(this->Mesh.cornerVertices[at(corner)],
    this->Mesh.cornerVertices[at(TriangleEdges::nextCorner(corner))]);
  return { low, high };
}

double TargetTriangles::edgeLength(Index edge) const
{
  const auto [a, b] = this->edgeVertices(edge);
  return (this->point(b) - this->point(a)).norm();
}

const Index* TargetTriangles::facesBegin(Index vertex) const
{
  return this->FacesOfVertices.data() + this->FaceOffsets[at(vertex)];
}

const Index* TargetTriangles::facesEnd(Index vertex) const
{
  return this->FacesOfVertices.data() + this->FaceOffsets[at(vertex) + 1];
}

void TargetTriangles::sortFacesByVertex()
{
  this->FaceOffsets.assign(this->Mesh.points.size() + 1, 0);
  for (const Index vertex : this->Mesh.cornerVertices)
  {
    ++this->FaceOffsets[at(vertex) + 1];
  }
  std::partial_sum(this->FaceOffsets.begin(), this->FaceOffsets.end(), this->FaceOffsets.begin());
  std::vector<Index> place(this->FaceOffsets.begin(), this->FaceOffsets.end() - 1);
  this->FacesOfVertices.resize(this->Mesh.cornerVertices.size());
  for (Index corner = 0; corner < this->Mesh.cornerCount(); ++corner)
  {
    const Index vertex = this->Mesh.cornerVertices[at(corner)];
    this->FacesOfVertices[at(place[at(vertex)]++)] = faceOf(corner);
  }
}

} // namespace evolving
