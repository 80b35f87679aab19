// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapTarget.h"

#include "Errors.h"
#include "StartSurface/Isosurface.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace evolving
{

namespace
{

/// Sheets without an inside become walls of this thickness on either side, in edge lengths and in
/// cells of the distance grid: thinner ones would fold (two layers of triangles closer than their
/// size), or could not be told from the distance's samples.
constexpr double WallPerEdge = 0.3;
constexpr double WallPerCell = 0.75;
/// A start surface has this many walls' thickness to evolve.
constexpr double LeastOffsetPerWall = 1.5;

void requireUsable(const SurfaceMesh& mesh, const Box& box, const ShrinkWrapOptions& options)
{
  validate(mesh);
  if (box.isEmpty() || !(box.diagonal().norm() > 0.0))
  {
    throw InputError("The input is a single point or empty, expected a surface or points with an "
                     "extent; check the file.");
  }
  for (const double length : { options.targetEdgeLength, options.gapSize, options.offsetDistance })
  {
    if (!std::isfinite(length) || length < 0.0)
    {
      std::ostringstream message;
      message << "TargetEdgeLength, GapSize or OffsetDistance is " << length
              << ", expected a finite length of at least 0; set 0 for an automatic one.";
      throw InputError(message.str());
    }
  }
}

/// The grid around the target with room for a start surface `reach` away from it.
DistanceGrid gridWithRoom(const Box& box, const std::array<int, 3>& dimensions, double reach)
{
  constexpr double LeastPadding = 0.1;
  const double needed = 1.5 * reach / box.sizes().maxCoeff();
  return gridAround(box, dimensions, std::max(LeastPadding, needed));
}

/// Points have no area of their own; the surface around them has.
double areaOf(const SurfaceMesh& mesh, const WrapTarget& target, const Execution& execution)
{
  if (mesh.faceCount() > 0)
  {
    return surfaceArea(mesh);
  }
  IsosurfaceOptions around;
  around.isoValue = 2.0 * target.cellSize();
  around.fillCavities = true;
  return surfaceArea(isosurface(target.grid, target.distance.distance, around, execution));
}

/// Two cells, an element, and between points three times their distance from each other.
double defaultGap(const SurfaceMesh& mesh, const WrapTarget& target)
{
  const double gap = std::max(2.0 * target.cellSize(), target.edgeLength);
  const double spacing = std::sqrt(target.area / mesh.vertexCount());
  return mesh.faceCount() > 0 ? gap : std::max(gap, 3.0 * spacing);
}

/// An inside thinner than a wall is a sheet's that winds about itself: it counts as none.
double wallOf(const WrapTarget& target)
{
  const double wall = std::max(WallPerEdge * target.edgeLength, WallPerCell * target.cellSize());
  const std::vector<float>& distance = target.distance.distance;
  const double deepest = *std::min_element(distance.begin(), distance.end());
  return deepest < -wall ? 0.0 : wall;
}

/// A sheet is the same from both sides.
void dropSigns(std::vector<float>& distance)
{
  for (float& value : distance)
  {
    value = std::abs(value);
  }
}

} // namespace

WrapTarget describeTarget(
  const SurfaceMesh& mesh, const ShrinkWrapOptions& options, const Execution& execution)
{
  WrapTarget target;
  target.box = boundingBox(mesh);
  requireUsable(mesh, target.box, options);
  const double reach = options.offsetDistance + 0.5 * options.gapSize;
  target.grid = gridWithRoom(target.box, options.sampleDimensions, reach);
  target.distance =
    signedDistance(mesh, target.grid, target.grid.extent, {}, execution.phase(0.0, 0.8));
  target.area = areaOf(mesh, target, execution.phase(0.8, 1.0));
  target.edgeLength =
    options.targetEdgeLength > 0.0 ? options.targetEdgeLength : defaultEdgeLength(target.area);
  if (!(target.edgeLength > 0.0))
  {
    throw InputError("The input has no area, expected faces that are not all degenerate; repair "
                     "it, or set TargetEdgeLength.");
  }
  target.wall = wallOf(target);
  if (target.wall > 0.0)
  {
    dropSigns(target.distance.distance);
  }
  const double gap = options.gapSize > 0.0 ? options.gapSize : defaultGap(mesh, target);
  target.offset = std::max(options.offsetDistance + 0.5 * gap, LeastOffsetPerWall * target.wall);
  return target;
}

} // namespace evolving
