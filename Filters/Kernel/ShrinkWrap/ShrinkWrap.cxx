// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ShrinkWrap.h"

#include "ShrinkWrap/WrapTarget.h"
#include "StartSurface/BoundingIcosphere.h"
#include "StartSurface/Isosurface.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "StartSurface/SurfaceComponents.h"

#include <algorithm>
#include <cmath>
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

/// The cell whose surface net has the vertex density of equilateral triangles of edge 1, which is
/// 2 / sqrt(3) per area: a net has a vertex for every 2/3 of a cell's side squared, because a
/// surface at all angles crosses |n_x| + |n_y| + |n_z| = 3/2 grid edges per cell side squared.
const double CellPerEdge = std::sqrt(0.75 * std::sqrt(3.0));

/// The start grid is refused its finest cells where it would have more samples than this.
constexpr double LargestStartGrid = 1e8;

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
  const WrapTarget& target, const ScalarImage& distance, const Execution& execution)
{
  const DistanceGrid grid = regrid(target.grid, CellPerEdge * target.edgeLength);
  const std::vector<float> values = resample(distance, grid, execution.phase(0.0, 0.4));
  IsosurfaceOptions options;
  options.isoValue = target.offset;
  options.fillCavities = true;
  options.relaxationSweeps = 2;
  const SurfaceMesh surface = isosurface(grid, values, options, execution.phase(0.4, 1.0));
  // Specks of one or two cells cannot carry a surface; but something must be left.
  const SurfaceMesh kept = dropSmallComponents(surface, 4.0 * grid.spacing.maxCoeff());
  return kept.faceCount() > 0 ? kept : surface;
}

/// The level whose vertices are as many as triangles of the edge length need on the target.
SurfaceMesh icosphereStart(const WrapTarget& target)
{
  const double edge = target.edgeLength;
  const double vertices = 2.0 * target.area / (std::sqrt(3.0) * edge * edge);
  const double level = std::log2(std::max(vertices, 12.0) / 10.0) / 2.0;
  const int nearest = std::clamp(static_cast<int>(std::lround(level)), 1, 8);
  return boundingIcosphere(target.box, nearest, 0.05);
}

/// The image whose zero level is where the result shall lie.
std::shared_ptr<const ScalarImage> targetField(const WrapTarget& target, double level)
{
  std::vector<float> values = target.distance.distance;
  for (float& value : values)
  {
    value -= static_cast<float>(level);
  }
  return std::make_shared<const ScalarImage>(target.grid, std::move(values));
}

FlowOptions flowFor(const WrapTarget& target, const ShrinkWrapOptions& options)
{
  const bool fromSphere = options.start == WrapStart::Icosphere;
  const double edge = target.edgeLength;
  const double radius = 0.5 * target.box.diagonal().norm();
  FlowOptions flow;
  flow.relativeUnits = false;
  flow.numberOfSteps = options.numberOfSteps;
  flow.advectionSpeed = 1.0;
  flow.advectionBalance = fromSphere ? 1.0 : 0.0;
  flow.timeStep = shrinkWrapTimeStep(options);
  // Curvature smooths over about an element per step, and fades within an element of the target.
  flow.curvatureSpeed = fromSphere ? 0.02 * radius * radius : 0.1 * edge * edge / flow.timeStep;
  flow.curvatureRange = fromSphere ? 0.04 * radius * radius : edge * edge;
  // The angle term alone: measured on nine closed models it leaves no fold and smallest angles of
  // 8 degrees or more, where any volume term leaves angles near 0 in concave creases.
  flow.redistribution.angle = 0.3 / flow.timeStep;
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
  const SurfaceMesh& mesh, const ShrinkWrapOptions& options, const Execution& execution)
{
  const WrapTarget target = describeTarget(mesh, options, execution.phase(0.0, 0.7));
  ShrinkWrapProblem problem;
  problem.edgeLength = target.edgeLength;
  problem.flow = flowFor(target, options);
  problem.field = targetField(target, std::max(options.offsetDistance, target.wall));
  if (options.start == WrapStart::Icosphere)
  {
    problem.start = icosphereStart(target);
  }
  else
  {
    const ScalarImage distance(target.grid, target.distance.distance);
    problem.start = isosurfaceStart(target, distance, execution.phase(0.7, 1.0));
  }
  return problem;
}

} // namespace evolving
