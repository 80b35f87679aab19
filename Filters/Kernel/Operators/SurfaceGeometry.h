// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Everything the velocities need to know about the current state of a surface.
 */

#ifndef EVOLVING_SURFACE_GEOMETRY_H
#define EVOLVING_SURFACE_GEOMETRY_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Operators/FiniteVolumes.h"

#include <vector>

namespace evolving
{

/// Matrices, normals and curvatures of one state.
class SurfaceGeometry
{
public:
  /// @param topology must outlive this object
  explicit SurfaceGeometry(const MeshTopology& topology);

  void update(const SurfaceMesh& mesh, const Execution& execution);

  const MeshTopology& topology() const { return this->Volumes.topology(); }
  const FiniteVolumes& volumes() const { return this->Volumes; }
  const std::vector<double>& coVolumes() const { return this->Volumes.coVolumes(); }
  /// N: unit angle-weighted pseudonormals; zero where the faces have no area.
  const std::vector<Vec3>& normals() const { return this->Normals; }
  /// h = Laplace F, see FiniteVolumes.
  const std::vector<Vec3>& curvatureVectors() const { return this->CurvatureVectors; }
  /// H = -h . N: +2/r on a sphere.
  double meanCurvature(Index vertex) const;

private:
  FiniteVolumes Volumes;
  std::vector<Vec3> Normals;
  std::vector<Vec3> CurvatureVectors;
};

/// The part of a vector tangential to the surface with unit normal N.
inline Vec3 tangentialPart(const Vec3& vector, const Vec3& normal)
{
  return vector - vector.dot(normal) * normal;
}

} // namespace evolving

#endif
