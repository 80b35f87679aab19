// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Fronts of a surface that come at each other while both are far from the target.
 */

#ifndef EVOLVING_FRONT_CONTACTS_H
#define EVOLVING_FRONT_CONTACTS_H

#include "Execution.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/**
 * Between two ears a closed surface goes down as a double sheet: its rim has to draw back to where
 * they meet, but its two sides go at each other faster. Takes vertices back to where they were
 * whose inward normal meets another side of the surface within a length, so that the sheet keeps
 * that thickness until its rim arrives.
 * @param before one point per vertex
 * @param distance from the target; only vertices farther from it than `thickness` are looked at
 * @return the number of vertices taken back
 * @throws Cancelled
 */
Index keepFrontsApart(SurfaceMesh& surface, const std::vector<Vec3>& before,
  const std::vector<double>& distance, double thickness, const Execution& execution = {});

} // namespace evolving

#endif
