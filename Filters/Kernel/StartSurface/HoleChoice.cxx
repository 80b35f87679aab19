// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/HoleChoice.h"

#include "Mesh/ConnectedComponents.h"

#include <algorithm>
#include <cstddef>

namespace evolving
{

namespace
{

/// Measured, see the header: between the holes of scans and the openings of shapes.
constexpr double LargestHole = 0.02;       ///< as a fraction of its component's area
constexpr double LargestSumOfHoles = 0.07; ///< likewise
constexpr double LeastContinuation = 0.4;
constexpr double OutlineContinuation = -0.9; ///< below it a cap lies on the sheet around

/// A connected component's area, and the flat caps of its loops.
struct Openings
{
  double area = 0.0;
  double largestCap = 0.0;
  double allCaps = 0.0;

  bool areSmall() const
  {
    return this->largestCap <= LargestHole * this->area &&
      this->allCaps <= LargestSumOfHoles * this->area;
  }
};

class ComponentOpenings
{
public:
  ComponentOpenings(const SurfaceMesh& mesh, const std::vector<BoundaryLoop>& loops)
    : Components(connectedComponents(mesh))
    , Of(at(Components.count))
  {
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      this->openingsAt(mesh.faceVertex(face, 0)).area += faceVectorArea(mesh, face).norm();
    }
    for (const BoundaryLoop& loop : loops)
    {
      Openings& openings = this->openingsAt(loop.vertices.front());
      const double cap = loop.vectorArea.norm();
      openings.largestCap = std::max(openings.largestCap, cap);
      openings.allCaps += cap;
    }
  }

  bool isScanHole(const BoundaryLoop& loop)
  {
    return loop.continuation >= LeastContinuation &&
      this->openingsAt(loop.vertices.front()).areSmall();
  }

private:
  Openings& openingsAt(Index vertex) { return this->Of[at(this->Components.ofVertex[at(vertex)])]; }

  ConnectedComponents Components;
  std::vector<Openings> Of;
};

} // namespace

std::vector<BoundaryLoop> holesToFill(
  const SurfaceMesh& mesh, const std::vector<BoundaryLoop>& loops, double gapSize, double narrow)
{
  ComponentOpenings components(mesh, loops);
  const double diameter = gapSize > 0.0 ? gapSize : narrow;
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : loops)
  {
    const bool isNarrow = loop.diameter < diameter && loop.continuation > OutlineContinuation;
    if (isNarrow || (gapSize == 0.0 && components.isScanHole(loop)))
    {
      holes.push_back(loop);
    }
  }
  return holes;
}

} // namespace evolving
