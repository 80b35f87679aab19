// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapTarget.h"

#include "Distance/SignedDistance.h"
#include "Errors.h"
#include "StartSurface/GapClosing.h"
#include "StartSurface/HoleChoice.h"
#include "StartSurface/HoleFilling.h"
#include "StartSurface/Isosurface.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// A start half an edge length away has the target's holes and handles, and is near enough to
/// arrive without folds. Nearer than this many cells the grid would show.
constexpr double StartPerEdge = 0.5;
constexpr double StartPerCell = 0.8;
/// Sheets that are reached from both sides become walls of this thickness on either side, in edge
/// lengths: two layers of triangles closer than that would fold through each other.
constexpr double WallPerEdge = 0.3;
/// Openings narrower than this many edge lengths are closed: elements cannot line them.
constexpr double NarrowEdges = 6.0;
/// The ball that stays outside of a point set: its diameter in distances between points, and in
/// cells of the grid; and how near it comes to a point, in cells.
constexpr double GapPerSpacing = 3.0;
constexpr double GapPerCell = 3.0;
constexpr double TouchPerCell = 0.1;
/// Between the start surface and the border of the grid.
constexpr double CellsOfRoom = 3.0;

void requireUsable(const SurfaceMesh& mesh, const Box& box)
{
  validate(mesh);
  if (box.isEmpty() || !(box.diagonal().norm() > 0.0))
  {
    throw InputError("The input is a single point or empty, expected a surface or points with an "
                     "extent; check the file.");
  }
}

/**
 * Cubic cells, as many as asked for along the axis that has the fewest for its length, and on the
 * other axes only as many of them as the box and the room around it need.
 */
DistanceGrid tightGrid(const Box& box, const std::array<int, 3>& dimensions, double room)
{
  double cell = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double cells = dimensions[static_cast<std::size_t>(axis)] - 1 - 2.0 * CellsOfRoom;
    cell = std::max(cell, (box.sizes()[axis] + 2.0 * room) / std::max(1.0, cells));
  }
  DistanceGrid grid;
  grid.spacing.setConstant(cell);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = box.sizes()[axis] + 2.0 * room + 2.0 * CellsOfRoom * cell;
    const int cells = static_cast<int>(std::ceil(side / cell - 1e-9));
    grid.origin[axis] = box.center()[axis] - 0.5 * cells * cell;
    const auto lower = static_cast<std::size_t>(2 * axis);
    grid.extent[lower] = 0;
    grid.extent[lower + 1] = cells;
  }
  return grid;
}

void requireArea(const WrapTarget& target)
{
  if (!(target.edgeLength > 0.0) || target.surface.faceCount() == 0)
  {
    throw InputError("The input has no area, expected faces that are not all degenerate; repair "
                     "it, or set TargetEdgeLength.");
  }
}

std::vector<float> distanceTo(
  const SurfaceMesh& surface, const DistanceGrid& grid, SignMethod sign, const Execution& execution)
{
  SignedDistanceOptions options;
  options.sign = sign;
  return signedDistance(surface, grid, grid.extent, options, execution).distance;
}

std::vector<float> magnitudes(std::vector<float> values)
{
  for (float& value : values)
  {
    value = std::abs(value);
  }
  return values;
}

double surfaceAround(const DistanceGrid& grid, const std::vector<float>& distance, double level,
  const Execution& execution)
{
  IsosurfaceOptions around;
  around.isoValue = level;
  around.fillCavities = true;
  return surfaceArea(isosurface(grid, distance, around, execution));
}

/**
 * The surface that a ball touches which cannot pass between the points: their union with all
 * that it cannot reach (GapClosing.h).
 */
SurfaceMesh surfaceThrough(const SurfaceMesh& points, const Box& box,
  const ShrinkWrapOptions& options, const Execution& execution)
{
  DistanceGrid grid = tightGrid(box, options.sampleDimensions, 0.0);
  const double cell = grid.spacing.maxCoeff();
  const double area =
    surfaceAround(grid, distanceTo(points, grid, SignMethod::Unsigned, execution.phase(0.0, 0.3)),
      2.0 * cell, execution.phase(0.3, 0.4));
  const double spacing = std::sqrt(area / points.vertexCount());
  const double gap = std::max({ options.gapSize, GapPerSpacing * spacing, GapPerCell * cell });
  grid = tightGrid(box, options.sampleDimensions, 0.5 * gap);
  const std::vector<float> field =
    closeGaps(grid, distanceTo(points, grid, SignMethod::Unsigned, execution.phase(0.4, 0.6)),
      TouchPerCell * cell, gap, execution.phase(0.6, 0.9));
  IsosurfaceOptions closed;
  closed.fillCavities = true;
  return isosurface(grid, field, closed, execution.phase(0.9, 1.0));
}

SurfaceMesh withoutHoles(const SurfaceMesh& surface, double gapSize, double edgeLength)
{
  const std::vector<BoundaryLoop> loops = boundaryLoops(surface);
  return fillHoles(surface, holesToFill(surface, loops, gapSize, NarrowEdges * edgeLength));
}

} // namespace

WrapTarget describeTarget(
  const SurfaceMesh& mesh, const ShrinkWrapOptions& options, const Execution& execution)
{
  checkOptions(options);
  WrapTarget target;
  target.box = boundingBox(mesh);
  requireUsable(mesh, target.box);
  const bool isPointSet = mesh.faceCount() == 0;
  target.surface = isPointSet ? surfaceThrough(mesh, target.box, options, execution.phase(0.0, 0.4))
                              : weldCoincidentPoints(mesh);
  target.area = surfaceArea(target.surface);
  target.edgeLength =
    options.targetEdgeLength > 0.0 ? options.targetEdgeLength : defaultEdgeLength(target.area);
  requireArea(target);
  const double gap = isPointSet ? 0.0 : options.gapSize;
  target.surface = withoutHoles(target.surface, gap, target.edgeLength);
  target.offset = options.offsetDistance;
  target.wall = WallPerEdge * target.edgeLength;
  const double room = target.offset + std::max(StartPerEdge * target.edgeLength, 0.5 * gap);
  target.grid = tightGrid(target.box, options.sampleDimensions, room);
  target.startLevel =
    target.offset + std::max(StartPerEdge * target.edgeLength, StartPerCell * target.cellSize());
  target.signedDistance =
    distanceTo(target.surface, target.grid, SignMethod::Automatic, execution.phase(0.5, 0.8));
  target.distance = magnitudes(target.signedDistance);
  target.startField =
    closeGaps(target.grid, target.distance, target.startLevel, gap, execution.phase(0.8, 1.0));
  return target;
}

} // namespace evolving
