// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/WindingWalk.h"

#include "Distance/Signs/OpenEdgeCaps.h"
#include "Distance/Signs/WindingSign.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

/// Samples nearer to the surface, in steps between samples, may be on either side of it.
constexpr double OnSurface = 1e-6;

SurfaceMesh capsOf(const DistanceTarget& target)
{
  SurfaceMesh caps;
  caps.points = target.mesh.points;
  for (const auto& [a, b, c] : capsOver(target.orientation.openEdges, caps.vertexCount()))
  {
    caps.addFace({ a, b, c });
  }
  return caps;
}

SurfaceMesh together(SurfaceMesh surface, const SurfaceMesh& caps)
{
  for (Index face = 0; face < caps.faceCount(); ++face)
  {
    surface.addFace(
      { caps.faceVertex(face, 0), caps.faceVertex(face, 1), caps.faceVertex(face, 2) });
  }
  return surface;
}

} // namespace

WindingField::WindingField(
  const DistanceTarget& target, const DistanceGrid& grid, const Execution& execution)
  : WindingField(target, capsOf(target), grid, execution)
{
}

WindingField::WindingField(const DistanceTarget& target, const SurfaceMesh& caps,
  const DistanceGrid& grid, const Execution& execution)
  : Surface(trianglesOf(target.mesh), execution.phase(0.0, 0.5))
  , Caps(trianglesOf(caps), execution.phase(0.5, 0.6))
  , Edges(target, grid)
  , Tree(together(target.mesh, caps), execution.phase(0.6, 1.0))
  , SurfaceFaces(target.mesh.faceCount())
  , Beside(OnSurface * grid.spacing.minCoeff() * Vec3(0.31, 0.27, 0.22))
{
}

bool WindingWalk::isInside(const WindingStep& way)
{
  this->carry(way);
  if (this->isInDoubt() && this->KnowsWhole)
  {
    this->Winding = this->Whole - this->Field->windingOfCaps(way.point);
    this->Drift = 0.0;
  }
  if (this->isInDoubt())
  {
    this->Winding = this->Field->windingOfSurface(way.point);
    this->Drift = 0.0;
    this->findWhole(way.point);
  }
  return this->Winding > WindingThreshold;
}

void WindingWalk::carry(const WindingStep& way)
{
  constexpr double Rounding = 1.0 + 1e-6;
  const double gap = 0.5 * (this->LastClearance + way.clearance - Rounding * way.length);
  const bool isClear = std::min(this->LastClearance, way.clearance) > OnSurface * way.length;
  this->LastClearance = way.clearance;
  this->Winding += way.change.surface;
  this->Whole += way.change.surface + way.change.caps;
  this->KnowsWhole = this->KnowsWhole && isClear;
  this->ToEdges -= way.length;
  if (this->ToEdges < std::max(gap, 0.5 * this->ToEdgesWhenMeasured))
  {
    // On the way here it was no less than at its ends less the step.
    this->ToEdges = this->ToEdgesWhenMeasured =
      this->Field->edges().distance(way.point) - way.length;
  }
  const double toEdges = std::max(gap, this->ToEdges);
  this->Drift += isClear && toEdges > 0.0 ? way.length * this->Field->edges().largestChange(toEdges)
                                          : std::numeric_limits<double>::infinity();
}

bool WindingWalk::isInDoubt() const
{
  // Twice the tolerance: what was evaluated, and what would be here.
  const double doubt = 2.0 * WindingNumber::Tolerance + this->Drift;
  return !(std::abs(this->Winding - WindingThreshold) > doubt);
}

void WindingWalk::findWhole(const Vec3& point)
{
  constexpr double Clearly = 0.25; // else something is too near to tell its sides
  const double sum = this->Winding + this->Field->windingOfCaps(point);
  this->Whole = std::round(sum);
  this->KnowsWhole = std::abs(sum - this->Whole) < Clearly;
}

} // namespace evolving
