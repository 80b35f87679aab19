// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StateCheck.h"

#include "Errors.h"
#include "Evolution/ParallelLoops.h"

#include <sstream>

namespace evolving
{

namespace
{

/// Half the sum of the cross products around a face: its area times its normal.
Vec3 vectorArea(const SurfaceMesh& faces, const std::vector<Vec3>& points, Index face)
{
  const Vec3& origin = points[at(faces.faceVertex(face, 0))];
  Vec3 sum = Vec3::Zero();
  for (Index k = 2; k < faces.faceSize(face); ++k)
  {
    sum += (points[at(faces.faceVertex(face, k - 1))] - origin)
             .cross(points[at(faces.faceVertex(face, k))] - origin);
  }
  return 0.5 * sum;
}

} // namespace

StateCheck::StateCheck(const SurfaceMesh& start, double guard)
  : Enlargement(guard)
  , StartArea(surfaceArea(start))
{
  if (guard > 0.0)
  {
    const Box box = boundingBox(start);
    // A flat start has a box without thickness; rounding may leave that.
    const Vec3 half = 0.5 * guard * box.diagonal() + Vec3::Constant(1e-9 * box.diagonal().norm());
    this->Guard = Box(Vec3(box.center() - half), Vec3(box.center() + half));
  }
}

void StateCheck::require(
  const SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution) const
{
  this->requireInside(mesh, execution);
  const double flipped = sumEachIndex(execution, mesh.faceCount(),
    [&](Index face)
    {
      const double agreement =
        vectorArea(mesh, mesh.points, face).dot(vectorArea(mesh, before, face));
      return agreement < 0.0 ? 1.0 : 0.0;
    });
  const double area = sumEachIndex(execution, mesh.faceCount(),
    [&](Index face) { return vectorArea(mesh, mesh.points, face).norm(); });
  if (area < SmallestAreaPart * this->StartArea)
  {
    throw SolverError("the surface has shrunk to points, expected fewer or shorter time steps.");
  }
  if (flipped > LargestFlippedPart * mesh.faceCount())
  {
    std::ostringstream message;
    message << flipped << " of " << mesh.faceCount()
            << " faces turned over in one step, expected at most a tenth; use a shorter time step "
               "or a weaker redistribution.";
    throw SolverError(message.str());
  }
}

void StateCheck::requireInside(const SurfaceMesh& mesh, const Execution& execution) const
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
    [&](Index i)
    { return this->Guard.isEmpty() || this->Guard.contains(mesh.points[at(i)]) ? 0.0 : 1.0; });
  if (outside > 0.0)
  {
    std::ostringstream message;
    message << outside << " points left the start's bounding box enlarged " << this->Enlargement
            << " times, expected none; use a shorter time step or a larger surface guard.";
    throw SolverError(message.str());
  }
}

} // namespace evolving
