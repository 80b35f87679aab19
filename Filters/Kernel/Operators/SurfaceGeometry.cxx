// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/SurfaceGeometry.h"

#include "Mesh/VertexNormals.h"
#include "ParallelLoops.h"

namespace evolving
{

SurfaceGeometry::SurfaceGeometry(const MeshTopology& topology)
  : Volumes(topology)
{
}

void SurfaceGeometry::update(const SurfaceMesh& mesh, const Execution& execution)
{
  this->Volumes.update(mesh, execution);
  this->Normals = angleWeightedNormals(mesh, this->topology(), execution);
  this->CurvatureVectors = this->Volumes.curvatureVectors(mesh, execution);
}

double SurfaceGeometry::meanCurvature(Index vertex) const
{
  return -this->CurvatureVectors[at(vertex)].dot(this->Normals[at(vertex)]);
}

} // namespace evolving
