// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ShrinkWrap.h"

#include "Distance/SignedDistance.h"
#include "Errors.h"
#include "StartSurface/BoundingIcosphere.h"
#include "StartSurface/Isosurface.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "StartSurface/SurfaceComponents.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <tuple>
#include <utility>

namespace evolving
{

namespace
{

constexpr double DefaultVertexCount = 9000.0;

/// The evolution's time: the distance to the target falls by exp(-7) = 0.001.
constexpr double IsosurfaceTime = 7.0;
/// From a sphere the distance is some hundred times as large.
constexpr double IcosphereTime = 12.0;

/// Two triangles from a square cell have the area of two equilateral triangles of edge L when the
/// cell's side is this times L.
const double CellPerEdge = std::sqrt(std::sqrt(3.0) / 2.0);

/// Sheets that have no inside become walls of this thickness on either side, in edge lengths:
/// thinner ones would fold (two layers of triangles closer than their size).
constexpr double WallPerEdge = 0.3;

/// The start grid is refused its finest cells where it would have more samples than this.
constexpr double LargestStartGrid = 1e8;

/// The target, its distance image and the lengths that follow from both.
struct Setting
{
  Box box;
  DistanceGrid grid;
  SignedDistanceResult distance;
  double edgeLength = 0.0;
  double offset = 0.0; ///< of the start surface from the target
};

void requireUsable(const SurfaceMesh& target, const Box& box, const ShrinkWrapOptions& options)
{
  validate(target);
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

double cellSize(const DistanceGrid& grid)
{
  return grid.spacing.maxCoeff();
}

/// The grid around the target with room for a start surface `reach` away from it.
DistanceGrid gridWithRoom(const Box& box, const std::array<int, 3>& dimensions, double reach)
{
  constexpr double LeastPadding = 0.1;
  const double needed = 1.5 * reach / box.sizes().maxCoeff();
  return gridAround(box, dimensions, std::max(LeastPadding, needed));
}

/// Points have no area of their own; the surface around them has.
double areaOf(const SurfaceMesh& target, const DistanceGrid& grid,
  const std::vector<float>& distance, const Execution& execution)
{
  if (target.faceCount() > 0)
  {
    return surfaceArea(target);
  }
  IsosurfaceOptions around;
  around.isoValue = 2.0 * cellSize(grid);
  around.fillCavities = true;
  return surfaceArea(isosurface(grid, distance, around, execution));
}

Setting describe(
  const SurfaceMesh& target, const ShrinkWrapOptions& options, const Execution& execution)
{
  Setting setting;
  setting.box = boundingBox(target);
  requireUsable(target, setting.box, options);
  const double reach = options.offsetDistance + 0.5 * options.gapSize;
  setting.grid = gridWithRoom(setting.box, options.sampleDimensions, reach);
  setting.distance =
    signedDistance(target, setting.grid, setting.grid.extent, {}, execution.phase(0.0, 0.7));
  setting.edgeLength = options.targetEdgeLength > 0.0
    ? options.targetEdgeLength
    : defaultEdgeLength(
        areaOf(target, setting.grid, setting.distance.distance, execution.phase(0.7, 0.8)));
  if (!(setting.edgeLength > 0.0))
  {
    throw InputError("The input has no area, expected faces that are not all degenerate; repair "
                     "it, or set TargetEdgeLength.");
  }
  const double gap = options.gapSize > 0.0
    ? options.gapSize
    : std::max(2.0 * cellSize(setting.grid), setting.edgeLength);
  setting.offset = options.offsetDistance + 0.5 * gap;
  return setting;
}

/// The grid over the same box with cells of another size.
DistanceGrid regrid(const DistanceGrid& grid, double cell)
{
  const Vec3 sides(grid.spacing.x() * (grid.dimension(0) - 1),
    grid.spacing.y() * (grid.dimension(1) - 1), grid.spacing.z() * (grid.dimension(2) - 1));
  const double finest = std::cbrt(sides.prod() / LargestStartGrid);
  const double size = std::max(cell, finest);
  DistanceGrid coarse;
  coarse.spacing.setConstant(size);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = std::max(1, static_cast<int>(std::ceil(sides[axis] / size)));
    coarse.origin[axis] = grid.origin[axis] - 0.5 * (cells * size - sides[axis]);
    coarse.extent[static_cast<std::size_t>(2 * axis + 1)] = cells;
  }
  for (const std::size_t lower : { 0, 2, 4 })
  {
    coarse.extent[lower] = 0;
  }
  return coarse;
}

std::vector<float> resample(
  const ScalarImage& image, const DistanceGrid& grid, const Execution& execution)
{
  std::vector<float> values(static_cast<std::size_t>(grid.sampleCount()));
  const int slices = grid.dimension(2);
  execution.forRangeReporting(slices, 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k)
      {
        for (int j = 0; j < grid.dimension(1); ++j)
        {
          for (int i = 0; i < grid.dimension(0); ++i)
          {
            values[static_cast<std::size_t>(grid.index(i, j, k))] =
              static_cast<float>(image.at(grid.point(i, j, k)).value);
          }
        }
      }
    });
  return values;
}

SurfaceMesh isosurfaceStart(
  const Setting& setting, const ScalarImage& distance, const Execution& execution)
{
  const DistanceGrid grid = regrid(setting.grid, CellPerEdge * setting.edgeLength);
  const std::vector<float> values = resample(distance, grid, execution.phase(0.0, 0.4));
  IsosurfaceOptions options;
  options.isoValue = setting.offset;
  options.fillCavities = true;
  options.relaxationSweeps = 2;
  const SurfaceMesh surface = isosurface(grid, values, options, execution.phase(0.4, 1.0));
  // Specks of one or two cells cannot carry a surface; but something must be left.
  const SurfaceMesh kept = dropSmallComponents(surface, 4.0 * cellSize(grid));
  return kept.faceCount() > 0 ? kept : surface;
}

/// The level whose vertices are as many as triangles of the edge length need on the target.
SurfaceMesh icosphereStart(const Setting& setting, double area)
{
  const double vertices = 2.0 * area / (std::sqrt(3.0) * setting.edgeLength * setting.edgeLength);
  const double level = std::log2(std::max(vertices, 12.0) / 10.0) / 2.0;
  const int nearest = std::clamp(static_cast<int>(std::lround(level)), 1, 8);
  return boundingIcosphere(setting.box, nearest, 0.05);
}

/// The image whose zero level is where the result shall lie.
std::shared_ptr<const ScalarImage> targetField(const Setting& setting, double level)
{
  std::vector<float> values = setting.distance.distance;
  for (float& value : values)
  {
    value -= static_cast<float>(level);
  }
  return std::make_shared<const ScalarImage>(setting.grid, std::move(values));
}

FlowOptions flowFor(const Setting& setting, const ShrinkWrapOptions& options)
{
  const bool fromSphere = options.start == WrapStart::Icosphere;
  const double edge = setting.edgeLength;
  const double radius = 0.5 * setting.box.diagonal().norm();
  FlowOptions flow;
  flow.relativeUnits = false;
  flow.numberOfSteps = options.numberOfSteps;
  flow.advectionSpeed = 1.0;
  flow.advectionBalance = fromSphere ? 1.0 : 0.0;
  flow.timeStep = shrinkWrapTimeStep(options);
  // Curvature smooths over about an element per step, and fades within an element of the target.
  flow.curvatureSpeed = fromSphere ? 0.02 * radius * radius : 0.1 * edge * edge / flow.timeStep;
  flow.curvatureRange = fromSphere ? 0.04 * radius * radius : edge * edge;
  flow.redistribution.angle = 0.3 / flow.timeStep;
  flow.redistribution.volume = 0.3 / flow.timeStep;
  return flow;
}

} // namespace

bool operator==(const ShrinkWrapOptions& a, const ShrinkWrapOptions& b)
{
  const auto values = [](const ShrinkWrapOptions& o)
  {
    return std::tie(o.start, o.sampleDimensions, o.targetEdgeLength, o.gapSize, o.numberOfSteps,
      o.offsetDistance);
  };
  return values(a) == values(b);
}

double defaultEdgeLength(double area)
{
  return std::sqrt(2.0 * area / (DefaultVertexCount * std::sqrt(3.0)));
}

double shrinkWrapTimeStep(const ShrinkWrapOptions& options)
{
  const bool fromSphere = options.start == WrapStart::Icosphere;
  return (fromSphere ? IcosphereTime : IsosurfaceTime) / std::max(1, options.numberOfSteps);
}

ShrinkWrapProblem prepareShrinkWrap(
  const SurfaceMesh& target, const ShrinkWrapOptions& options, const Execution& execution)
{
  const Setting setting = describe(target, options, execution.phase(0.0, 0.7));
  const bool hasInside = setting.distance.sign != SignMethod::Unsigned;
  const double wall = hasInside ? 0.0 : WallPerEdge * setting.edgeLength;
  ShrinkWrapProblem problem;
  problem.edgeLength = setting.edgeLength;
  problem.flow = flowFor(setting, options);
  problem.field = targetField(setting, std::max(options.offsetDistance, wall));
  if (options.start == WrapStart::Icosphere)
  {
    const double area =
      areaOf(target, setting.grid, setting.distance.distance, execution.phase(0.7, 0.9));
    problem.start = icosphereStart(setting, area);
  }
  else
  {
    const ScalarImage distance(setting.grid, setting.distance.distance);
    problem.start = isosurfaceStart(setting, distance, execution.phase(0.7, 1.0));
  }
  return problem;
}

} // namespace evolving
