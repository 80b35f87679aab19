// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The connected parts of a surface, kept or dropped whole.
 */

#ifndef EVOLVING_SURFACE_COMPONENTS_H
#define EVOLVING_SURFACE_COMPONENTS_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <vector>

namespace evolving
{

/// One connected component. Here as in the functions below, surfaces are oriented and manifold;
/// they throw InputError as MeshTopology does when not.
struct SurfaceComponent
{
  Box box;
  double area = 0.0;
  double volume = 0.0; ///< enclosed; negative where faces point into a cavity
  Index faces = 0;
};

/**
 * The components (connected by shared vertices) in the order of their smallest vertex; unused
 * vertices belong to none.
 */
std::vector<SurfaceComponent> surfaceComponents(const SurfaceMesh& mesh);

/// Only the component of largest area; of equals the first.
SurfaceMesh keepLargestComponent(const SurfaceMesh& mesh);

/// In cells: specks whose boxes have shorter diagonals cannot carry a surface on that grid.
constexpr double SpeckCells = 4.0;

/**
 * Without the components whose box has a diagonal shorter than a length (in the input's unit):
 * specks of a noisy field. Vertices and faces keep their order.
 */
SurfaceMesh dropSmallComponents(const SurfaceMesh& mesh, double shortestDiagonal);

/**
 * Without the components that enclose a negative volume: the walls of cavities. What floats in a
 * cavity stays; to be rid of both use IsosurfaceOptions::fillCavities.
 */
SurfaceMesh dropCavityWalls(const SurfaceMesh& mesh);

} // namespace evolving

#endif
