// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Triangles between whole numbers, and an answer to their intersection that is slow and exact.
 */

#ifndef EVOLVING_LATTICE_TRIANGLES_H
#define EVOLVING_LATTICE_TRIANGLES_H

#include "Mesh/TrianglePairs.h"

#include <cstdint>
#include <random>
#include <vector>

namespace evolving
{

using IntegerVector = Eigen::Matrix<std::int64_t, 3, 1>;

struct LatticeTriangles
{
  std::vector<IntegerVector> points;
  std::vector<TriangleVertices> triangles;
};

/// Few points on a small lattice: touching, coplanar and equal points abound.
LatticeTriangles randomLatticeTriangles(std::mt19937& generator);

/// What intersectBeyondShared() should say, by separating axes in integer arithmetic.
bool latticeTrianglesIntersect(
  const LatticeTriangles& mesh, const TriangleVertices& first, const TriangleVertices& second);

} // namespace evolving

#endif
