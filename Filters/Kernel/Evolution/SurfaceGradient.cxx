// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceGradient.h"

#include "Evolution/ParallelLoops.h"
#include "Evolution/PolygonLaplacian.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// Every corner's part of the sums at the vertices.
std::vector<Vec3> cornerGradients(
  const SurfaceMesh& mesh, const std::vector<double>& values, const Execution& execution)
{
  std::vector<Vec3> gradients(mesh.cornerVertices.size());
  execution.forRange(mesh.faceCount(), LoopGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<Vec3> corners;
      std::vector<double> cornerValues;
      std::vector<Vec3> parts;
      for (auto face = static_cast<Index>(begin); face < static_cast<Index>(end); ++face)
      {
        corners.clear();
        cornerValues.clear();
        for (Index k = 0; k < mesh.faceSize(face); ++k)
        {
          corners.push_back(mesh.facePoint(face, k));
          cornerValues.push_back(values[at(mesh.faceVertex(face, k))]);
        }
        computeFaceGradient(corners, cornerValues, parts);
        std::copy(parts.begin(), parts.end(), gradients.begin() + mesh.faceOffsets[at(face)]);
      }
    });
  return gradients;
}

} // namespace

std::vector<Vec3> surfaceGradient(const SurfaceMesh& mesh, const FiniteVolumes& volumes,
  const std::vector<double>& values, const Execution& execution)
{
  const std::vector<Vec3> parts = cornerGradients(mesh, values, execution);
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
