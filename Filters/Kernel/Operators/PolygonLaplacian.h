// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The cotangent scheme of section 4.2 on one face, triangle or polygon.
 *
 * A polygon gets a virtual vertex, an affine combination of its corners, and becomes a fan of
 * triangles around it; what the triangles say about the virtual vertex is folded back onto the
 * corners (Bunge, Herholz, Kazhdan, Botsch, *Polygon Laplacian Made Simple*, 2020):
 * L = P^T L_tri P, mu = row sums of P^T M_tri P. A triangle stays as it is.
 */

#ifndef EVOLVING_POLYGON_LAPLACIAN_H
#define EVOLVING_POLYGON_LAPLACIAN_H

#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// What one face adds to the matrices of a mesh.
struct FaceStencil
{
  /**
   * Weights w_ij of the face's Laplacian, (L f)_i = sum_j w_ij (f_i - f_j), for the ordered
   * pairs of corners: each corner with the others in the order round the face, (0, 1), (0, 2),
   * ..., (1, 2), ..., (1, 0), ...
   */
  std::vector<double> pairWeights;
  /// Each corner's share of the face's area.
  std::vector<double> cornerAreas;
};

/// The affine combination of a polygon's corners that replaces it by a fan of triangles.
struct VirtualVertex
{
  std::vector<double> weights; ///< one per corner, summing to 1
  Vec3 point = Vec3::Zero();
};

/**
 * The point that minimises the summed squared areas of the fan, with the weights of the smallest
 * norm that produce it. Corners on one line give their mean.
 */
VirtualVertex virtualVertex(const std::vector<Vec3>& corners);

/**
 * The half cotangents at the three corners of a triangle.
 * A degenerate triangle counts as one whose area is 1e-8 of its longest edge's square, so that
 * weights stay finite; all three cotangents have this one denominator, so that L stays positive
 * semi-definite. A triangle without extent has zeros.
 */
std::array<double, 3> halfCotangents(const Vec3& a, const Vec3& b, const Vec3& c);

double triangleArea(const Vec3& a, const Vec3& b, const Vec3& c);

/**
 * @param corners at least three points
 * @param[out] stencil its arrays are resized
 */
void computeFaceStencil(const std::vector<Vec3>& corners, FaceStencil& stencil);

/**
 * What one face adds to the gradient of a function given at its corners: for every corner the
 * sum over the fan's triangles of (share of the corner in the triangle's area) * gradient.
 * On a triangle each corner gets a third of area times gradient.
 * @param[out] cornerGradients one per corner
 */
void computeFaceGradient(const std::vector<Vec3>& corners, const std::vector<double>& values,
  std::vector<Vec3>& cornerGradients);

} // namespace evolving

#endif
