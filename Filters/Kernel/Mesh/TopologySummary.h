// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What kind of surface a mesh is: closed, manifold, oriented, of which genus.
 */

#ifndef EVOLVING_TOPOLOGY_SUMMARY_H
#define EVOLVING_TOPOLOGY_SUMMARY_H

#include "Mesh/SurfaceMesh.h"
#include "Types.h"

namespace evolving
{

/// Counts that say what kind of surface a mesh is.
struct TopologySummary
{
  Index usedVertices = 0;
  Index edges = 0;
  Index faces = 0;
  Index boundaryEdges = 0;       ///< edges of one face
  Index nonManifoldEdges = 0;    ///< edges of more than two faces
  Index flippedEdges = 0;        ///< edges whose two faces run along them in the same direction
  Index nonManifoldVertices = 0; ///< vertices where several fans of faces meet
  Index components = 0;          ///< connected by shared vertices

  bool isClosed() const { return this->boundaryEdges == 0 && this->nonManifoldEdges == 0; }
  bool isManifold() const { return this->nonManifoldEdges == 0 && this->nonManifoldVertices == 0; }
  bool isOriented() const { return this->flippedEdges == 0; }
  Index eulerCharacteristic() const { return this->usedVertices - this->edges + this->faces; }
  /// The sum of the components' genera; only for closed, manifold, oriented surfaces.
  Index genus() const { return (2 * this->components - this->eulerCharacteristic()) / 2; }
};

/// Works for every mesh that validate() accepts, however dirty.
TopologySummary summarizeTopology(const SurfaceMesh& mesh);

} // namespace evolving

#endif
