// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/InsideOutside.h"

#include "Distance/ClosestTriangles.h"
#include "Distance/Signs/FloodFill.h"
#include "Distance/Signs/PseudonormalSign.h"
#include "Distance/Signs/Pseudonormals.h"
#include "Distance/Signs/WindingNumber.h"
#include "Distance/Signs/WindingSign.h"
#include "Errors.h"
#include "Mesh/SelfIntersections.h"

#include <cmath>
#include <sstream>

namespace evolving
{

namespace
{

SignChoice choiceForClosedSurface(const DistanceTarget& target, const Execution& execution)
{
  std::ostringstream reason;
  reason << "The surface is closed";
  if (target.orientation.turnedFaces > 0)
  {
    reason << " (" << target.orientation.turnedFaces << " faces were turned outwards)";
  }
  const std::size_t crossings = selfIntersections(target.mesh, execution).size();
  if (crossings > 0)
  {
    reason << " but meets itself (" << crossings
           << " pairs of faces), so the winding number gives the sign.";
    return { SignMethod::WindingNumber, reason.str() };
  }
  reason << ", so the normal at the closest point gives the sign.";
  return { SignMethod::Pseudonormal, reason.str() };
}

SignChoice choiceForSurface(const DistanceTarget& target, const Execution& execution)
{
  const OrientationSummary& surface = target.orientation;
  if (surface.isClosed() && surface.isOriented() && !surface.componentsOverlap)
  {
    return choiceForClosedSurface(target, execution);
  }
  std::ostringstream reason;
  if (surface.boundaryEdges > 0)
  {
    reason << "The surface has " << surface.boundaryEdges << " boundary edges";
  }
  else if (surface.nonManifoldEdges > 0)
  {
    reason << "The surface has " << surface.nonManifoldEdges << " edges of more than two faces";
  }
  else if (!surface.isOriented())
  {
    reason << "The surface is one-sided";
  }
  else
  {
    reason << "The surface has " << surface.components
           << " components that may intersect or enclose each other";
  }
  reason << ", so the winding number gives the sign.";
  return { SignMethod::WindingNumber, reason.str() };
}

Vec3 samplePoint(const DistanceGrid& grid, GridIndex sample)
{
  const GridIndex row = sample / grid.dimension(0);
  return grid.point(grid.extent[0] + static_cast<int>(sample % grid.dimension(0)),
    grid.extent[2] + static_cast<int>(row % grid.dimension(1)),
    grid.extent[4] + static_cast<int>(row / grid.dimension(1)));
}

std::vector<char> insideByFloodFill(const DistanceTarget& target, const DistanceGrid& grid,
  const UnsignedDistance& samples, const Execution& execution)
{
  const Pseudonormals normals(target.mesh, target.orientation.edgeOfCorner);
  const auto cellRadius = static_cast<float>(0.5 * grid.spacing.norm());
  const std::vector<float>& clearance = samples.lowerBound();
  FloodFillQueries queries;
  queries.isNearSurface = [&](GridIndex sample)
  { return samples.triangle[at(sample)] != NoIndex && clearance[at(sample)] <= cellRadius; };
  queries.isBehindSurface = [&](GridIndex sample)
  {
    const Vec3 point = samplePoint(grid, sample);
    const Index triangle = samples.triangle[at(sample)];
    return normals.isInside(
      point, triangle, closestPointOnTriangle(point, triangleOf(target.mesh, triangle)));
  };
  WindingNumber winding({});
  if (!containsAll(grid, boundingBox(target.mesh)))
  {
    winding = WindingNumber(trianglesOf(target.mesh), execution.phase(0.0, 0.2));
    queries.isInside = [&](GridIndex sample)
    { return winding.at(samplePoint(grid, sample)) > WindingThreshold; };
  }
  return floodFill(grid, clearance, queries, execution.phase(0.2, 1.0));
}

} // namespace

SignChoice chooseSignMethod(
  SignMethod asked, const DistanceTarget& target, const Execution& execution)
{
  if (target.isPointSet)
  {
    if (asked != SignMethod::Automatic && asked != SignMethod::Unsigned)
    {
      throw InputError("The input has points but no faces, so it has no inside; expected a "
                       "surface, or the sign method Unsigned or Automatic.");
    }
    return { SignMethod::Unsigned, "Points have no inside, so the distance is unsigned." };
  }
  if (asked != SignMethod::Automatic)
  {
    return { asked, "The sign method was chosen by the user." };
  }
  return choiceForSurface(target, execution);
}

std::vector<char> samplesInside(SignMethod method, const DistanceTarget& target,
  const DistanceGrid& grid, const UnsignedDistance& samples, const Execution& execution)
{
  switch (method)
  {
    case SignMethod::FloodFill:
      return insideByFloodFill(target, grid, samples, execution);
    case SignMethod::WindingNumber:
      return insideByWindingNumber(target, grid, samples.lowerBound(), execution);
    case SignMethod::Pseudonormal:
      return insideByPseudonormal(target, grid, samples, execution);
    case SignMethod::Automatic:
    case SignMethod::Unsigned:
      break;
  }
  return std::vector<char>(samples.distance.size(), 0);
}

} // namespace evolving
