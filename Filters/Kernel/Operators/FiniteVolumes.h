// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The finite volume discretization of a surface (chapter 4 of the thesis): stiffness matrix and
 * barycentric co-volumes.
 */

#ifndef EVOLVING_FINITE_VOLUMES_H
#define EVOLVING_FINITE_VOLUMES_H

#include "Algebra/SparseMatrix.h"
#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * L and mu of a surface whose points move while its faces stay. The constructor finds out where
 * in the sparse matrix each corner of each face adds its numbers; update() then only computes
 * and gathers them, row by row, without searching.
 *
 * (L f)_i = sum_j w_ij (f_i - f_j), w_ij = (cot alpha_ij + cot beta_ij) / 2 on triangles:
 * symmetric, positive semi-definite, so that Laplace f = -M^-1 L f with M = diag(mu_i).
 */
class FiniteVolumes
{
public:
  /// @param topology must outlive this object
  explicit FiniteVolumes(const MeshTopology& topology);

  /// Computes L and mu for new positions. A mesh with the faces given to the constructor.
  void update(const SurfaceMesh& mesh, const Execution& execution);

  /// L. A row of zeros for a vertex without faces.
  const SparseMatrix& stiffness() const { return this->L; }

  /**
   * mu_i (4.22), a third of each incident triangle's area, in length^2; they sum to the area.
   * Vertices whose faces have no area (or that have no faces) get 1e-12 of the mean instead of
   * zero, so that divisions by mu_i stay finite.
   */
  const std::vector<double>& coVolumes() const { return this->CoVolumes; }

  /**
   * h = Laplace F = -M^-1 L F (4.14), one vector per vertex, in 1/length: inwards with length
   * 2/r on a sphere. Computed from differences of points, so that a surface far from the origin
   * loses nothing. At a boundary vertex it contains the pull along the surface.
   */
  std::vector<Vec3> curvatureVectors(const SurfaceMesh& mesh, const Execution& execution) const;

  /// FaceStencil::pairWeights of the face whose first corner this is.
  const double* pairWeights(Index firstCorner) const
  {
    return this->PairWeights.data() + this->PairOffsets[static_cast<std::size_t>(firstCorner)];
  }

  const MeshTopology& topology() const { return this->Topology; }

private:
  void buildPattern();
  void locatePairs();
  void computeFaces(const SurfaceMesh& mesh, const Execution& execution);
  void gatherRow(Index row);
  void raiseVanishingCoVolumes(const Execution& execution);

  const MeshTopology& Topology;
  SparseMatrix L;
  std::vector<Index> Diagonal; ///< position of a_ii in L's values
  std::vector<double> CoVolumes;
  /// Of each corner the range of its pairs with the face's other corners, as in FaceStencil.
  std::vector<Index> PairOffsets;
  std::vector<Index> PairPositions; ///< of each pair's entry in L's values
  std::vector<double> PairWeights;
  std::vector<double> CornerAreas;
};

/// The sum of the co-volumes: the area of the surface.
double totalArea(const std::vector<double>& coVolumes, const Execution& execution);

} // namespace evolving

#endif
