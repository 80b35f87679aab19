// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * How far advection may move a vertex in a step.
 */

#ifndef EVOLVING_ADVECTION_LIMIT_H
#define EVOLVING_ADVECTION_LIMIT_H

#include "Execution.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"

#include <vector>

namespace evolving
{

/**
 * Limits speeds to a part of the mean edge length around each vertex per step: elements that move
 * by more than their own length fold where the directions meet.
 * @param longest in mean edge lengths; 0 sets no limit
 * @param[in,out] speed eta, one per vertex
 */
void limitByEdges(const SurfaceMesh& mesh, const MeshTopology& topology, double longest,
  double timeStep, std::vector<double>& speed, const Execution& execution);

} // namespace evolving

#endif
