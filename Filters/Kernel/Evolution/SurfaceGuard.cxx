// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceGuard.h"

#include "ParallelLoops.h"
#include "Redistribution/VanishedComponents.h"

#include <sstream>

namespace evolving
{

SurfaceGuard::SurfaceGuard(const SurfaceMesh& start, const Box& image, double guard)
  : Enlargement(guard)
  , StartArea(surfaceArea(start))
{
  const Box box = boundingBox(start).merged(image);
  // A flat start has a box without thickness; rounding may leave that.
  const Vec3 half = 0.5 * guard * box.diagonal() + Vec3::Constant(1e-9 * box.diagonal().norm());
  this->Guard = Box(Vec3(box.center() - half), Vec3(box.center() + half));
}

void SurfaceGuard::require(const SurfaceMesh& mesh, const Execution& execution) const
{
  this->requireInside(mesh, execution);
  const double area = sumEachIndex(
    execution, mesh.faceCount(), [&](Index face) { return faceVectorArea(mesh, face).norm(); });
  if (area < SmallestAreaPart * this->StartArea)
  {
    throw SurfaceVanished(
      "the surface has shrunk to points, expected fewer or shorter time steps.");
  }
}

void SurfaceGuard::requireInside(const SurfaceMesh& mesh, const Execution& execution) const
{
  const double infinite = sumEachIndex(execution, mesh.vertexCount(),
    [&](Index i) { return mesh.points[at(i)].allFinite() ? 0.0 : 1.0; });
  if (infinite > 0.0)
  {
    std::ostringstream message;
    message << infinite << " points have coordinates that are not finite, expected numbers; use a "
            << "shorter time step.";
    throw SolverError(message.str());
  }
  const double outside = sumEachIndex(execution, mesh.vertexCount(),
    [&](Index i) { return this->Guard.contains(mesh.points[at(i)]) ? 0.0 : 1.0; });
  if (outside > 0.0)
  {
    std::ostringstream message;
    message << outside << " points left the bounding box of the start and the field enlarged "
            << this->Enlargement
            << " times, expected none; use a shorter time step or a larger surface guard.";
    throw SolverError(message.str());
  }
}

} // namespace evolving
