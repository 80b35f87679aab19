// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Section 4.2 of the thesis, vertex by vertex as it is printed: cotangent weights, co-volumes and
 * mean curvature vectors of a closed surface of triangles.
 */

#ifndef BENCHMARK_THESIS_GEOMETRY_H
#define BENCHMARK_THESIS_GEOMETRY_H

#include "Mesh/SurfaceMesh.h"

#include <Eigen/SparseCore>

#include <vector>

namespace benchmark
{

/// The neighbours of every vertex, counter-clockwise (algorithm 3).
using Rings = std::vector<std::vector<evolving::Index>>;

/// Entry p of a ring after p turns; p may be -1 or the ring's length.
template <class Value>
const Value& around(const std::vector<Value>& ring, int p)
{
  const int size = static_cast<int>(ring.size());
  return ring[static_cast<std::size_t>((p + size) % size)];
}

/// A surface at time t.
struct ThesisGeometry
{
  std::vector<Eigen::Triplet<double>> L; ///< (L f)_i = sum_p w_ip (f_i - f_p), from (4.14)
  Eigen::VectorXd mu;                    ///< (4.22)
  Eigen::MatrixX3d h;                    ///< (4.14) divided by mu: inwards on a sphere
};

Rings ringsOf(const evolving::SurfaceMesh& mesh);

/// @param F one vertex per row
ThesisGeometry thesisGeometry(const Rings& rings, const Eigen::MatrixX3d& F);

} // namespace benchmark

#endif
