// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The length-based tangential velocity (section 3.3.2): the segments of curves on the surface
 * grow equally long.
 */

#ifndef EVOLVING_LENGTH_REDISTRIBUTION_H
#define EVOLVING_LENGTH_REDISTRIBUTION_H

#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"
#include "Redistribution/SurfaceCurves.h"

#include <vector>

namespace evolving
{

/**
 * The speeds alpha_k along a chain (3.23): with segments l_k from vertex k to k + 1, their sum
 * Lambda, m segments and k the chain's own curvature vector,
 * alpha_k+1 - alpha_k = l_k ((k . v_N)_k - mean) + omega (Lambda / m - l_k).
 * An open chain has alpha = 0 at both ends, a closed one sum_k alpha_k = 0.
 * @param normalVelocity v_N, one per vertex of the surface
 * @param rate omega
 * @param largestRate bound for |k . v_N|, 1/time
 * @return one per vertex of the chain
 */
std::vector<double> chainSpeeds(const VertexChain& chain, const std::vector<Vec3>& points,
  const std::vector<Vec3>& normalVelocity, double rate, double largestRate);

/// The length-based velocity along boundary and crease curves and along edge chains.
class LengthRedistribution
{
public:
  LengthRedistribution(const MeshTopology& topology, const SurfaceCurves& curves);

  /**
   * v_T at a vertex: the mean of alpha T over the chains it is an inner vertex of, projected to
   * the tangent plane; zero when there is none.
   * @param normals unit normals at the vertices
   */
  std::vector<Vec3> velocity(const SurfaceMesh& mesh, const std::vector<Vec3>& normals,
    const std::vector<Vec3>& normalVelocity, double rate, double largestRate,
    const Execution& execution) const;

private:
  std::vector<VertexChain> Chains;
  std::vector<Index> EntryOffsets; ///< of each chain's first vertex among all chains' vertices
};

} // namespace evolving

#endif
