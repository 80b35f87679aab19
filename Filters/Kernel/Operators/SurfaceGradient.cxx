// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/SurfaceGradient.h"

#include "Operators/PolygonLaplacian.h"
#include "ParallelLoops.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// What the faces add, one after another.
class FaceGradients
{
public:
  FaceGradients(
    const SurfaceMesh& mesh, const FiniteVolumes& volumes, const std::vector<double>& values)
    : Mesh(mesh)
    , Volumes(volumes)
    , Values(values)
  {
  }

  /// @param[out] gradients one per corner of the face
  void compute(Index face, Vec3* gradients)
  {
    if (this->Mesh.faceSize(face) == 3)
    {
      std::fill_n(gradients, 3, this->ofTriangle(face));
      return;
    }
    this->Corners.clear();
    this->CornerValues.clear();
    for (Index k = 0; k < this->Mesh.faceSize(face); ++k)
    {
      this->Corners.push_back(this->Mesh.facePoint(face, k));
      this->CornerValues.push_back(this->value(face, k));
    }
    computeFaceGradient(this->Corners, this->CornerValues, this->Parts);
    std::copy(this->Parts.begin(), this->Parts.end(), gradients);
  }

private:
  double value(Index face, Index k) const
  {
    return this->Values[at(this->Mesh.faceVertex(face, k))];
  }

  /// A third of area times gradient. With the edges' weights, half the cotangents opposite, that is
  /// the sum over them of weight times difference times edge: neither normal nor root are needed.
  Vec3 ofTriangle(Index face) const
  {
    const SurfaceMesh& mesh = this->Mesh;
    const double* const w = this->Volumes.pairWeights(mesh.faceOffsets[at(face)]);
    const Vec3 ab = mesh.facePoint(face, 1) - mesh.facePoint(face, 0);
    const Vec3 ac = mesh.facePoint(face, 2) - mesh.facePoint(face, 0);
    const double f = this->value(face, 0);
    const double toB = this->value(face, 1) - f;
    const double toC = this->value(face, 2) - f;
    return (w[0] * toB * ab + w[1] * toC * ac + w[2] * (toC - toB) * (ac - ab)) / 3.0;
  }

  const SurfaceMesh& Mesh;
  const FiniteVolumes& Volumes;
  const std::vector<double>& Values;
  std::vector<Vec3> Corners; ///< of one polygon
  std::vector<double> CornerValues;
  std::vector<Vec3> Parts;
};

/// Every corner's part of the sums at the vertices.
std::vector<Vec3> cornerGradients(const SurfaceMesh& mesh, const FiniteVolumes& volumes,
  const std::vector<double>& values, const Execution& execution)
{
  std::vector<Vec3> gradients(mesh.cornerVertices.size());
  execution.forRange(mesh.faceCount(), LoopGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      FaceGradients faces(mesh, volumes, values);
      for (auto face = static_cast<Index>(begin); face < static_cast<Index>(end); ++face)
      {
        faces.compute(face, gradients.data() + mesh.faceOffsets[at(face)]);
      }
    });
  return gradients;
}

} // namespace

std::vector<Vec3> surfaceGradient(const SurfaceMesh& mesh, const FiniteVolumes& volumes,
  const std::vector<double>& values, const Execution& execution)
{
  const std::vector<Vec3> parts = cornerGradients(mesh, volumes, values, execution);
  std::vector<Vec3> gradient(mesh.points.size());
  forEachIndex(execution, mesh.vertexCount(),
    [&](Index i)
    {
      Vec3 sum = Vec3::Zero();
      for (const Index corner : volumes.topology().ringCorners(i))
      {
        sum += parts[at(corner)];
      }
      gradient[at(i)] = sum / volumes.coVolumes()[at(i)];
    });
  return gradient;
}

} // namespace evolving
