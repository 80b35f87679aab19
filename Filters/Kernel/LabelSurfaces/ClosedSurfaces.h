// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The closed surface of every label, of the interfaces that it has with others.
 */

#ifndef EVOLVING_CLOSED_SURFACES_H
#define EVOLVING_CLOSED_SURFACES_H

#include "Execution.h"
#include "LabelSurfaces/InterfaceNet.h"
#include "LabelSurfaces/InterfaceTriangles.h"
#include "Mesh/SurfaceMesh.h"
#include "Types.h"

#include <array>
#include <vector>

namespace evolving
{

/// The surfaces of all labels, one after another, without common vertices.
struct ClosedSurfaces
{
  SurfaceMesh mesh;
  std::vector<Index> triangles; ///< of every face, the triangle that it is
  std::vector<Material> labels; ///< of every face
  std::vector<Material> others; ///< of every face, the material at its other side
};

/**
 * A label's voxels hang together by faces. Where they meet by an edge or a corner alone, the
 * surface passes there more than once, with a vertex of its own each time; all of them at the same
 * place. An edge whose ends are the same vertices for both passes is split first, so that its
 * middle tells them apart. So every surface is a closed manifold, oriented outwards.
 * @param[in,out] triangles edges may get split
 * @param[in,out] points of the vertices; gets the middles of those edges
 * @throws Cancelled
 */
ClosedSurfaces closedSurfaces(const InterfaceNet& net, InterfaceTriangles& triangles,
  std::vector<Vec3>& points, const Execution& execution);

} // namespace evolving

#endif
