// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ShrinkWrap.h"

#include "ParallelLoops.h"
#include "ShrinkWrap/OuterRegion.h"
#include "ShrinkWrap/WrapRemesher.h"
#include "ShrinkWrap/WrapTarget.h"
#include "StartSurface/BoundingIcosphere.h"

#include <cmath>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// Levels of walls matter to the flow within this many start levels of the target only.
constexpr double NearLevels = 2.0;
/// Positions need no more: remeshing follows.
constexpr double SolverTolerance = 1e-6;
constexpr int StallSteps = 8;

/**
 * The distance less the level at which the result lies. What the region contains is outside; next
 * to the target its own sides count, but not where it has sheets.
 */
std::shared_ptr<const ScalarImage> levelField(const WrapTarget& target, const OuterRegion& region,
  const WrapReference& reference, const Execution& execution)
{
  const DistanceGrid& grid = target.grid;
  std::vector<float> values(target.distance.size());
  const auto valueAt = [&](std::size_t sample, const Vec3& point)
  {
    const bool isOutside = reference.hasSheets() || region.contains(sample);
    const double distance = isOutside ? target.distance[sample] : target.signedDistance[sample];
    const bool isNear = target.distance[sample] < NearLevels * target.startLevel;
    return distance - (isNear ? reference.levelNear(point) : target.offset);
  };
  execution.forRangeReporting(grid.dimension(2), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k)
      {
        for (int j = 0; j < grid.dimension(1); ++j)
        {
          for (int i = 0; i < grid.dimension(0); ++i)
          {
            const auto sample = static_cast<std::size_t>(grid.index(i, j, k));
            values[sample] = static_cast<float>(valueAt(sample, grid.point(i, j, k)));
          }
        }
      }
    });
  return std::make_shared<const ScalarImage>(grid, std::move(values));
}

/// A sphere around the target that its flow can leave in triangles of the largest size.
SurfaceMesh sphereStart(const WrapTarget& target)
{
  constexpr int Level = 3;
  constexpr double Margin = 0.05;
  Box box = target.box;
  box.extend(Vec3(box.max().array() + target.offset));
  box.extend(Vec3(box.min().array() - target.offset));
  return boundingIcosphere(box, Level, Margin);
}

FlowOptions flowFor(const WrapTarget& target, const ShrinkWrapOptions& options)
{
  const double edge = target.edgeLength;
  FlowOptions flow;
  flow.relativeUnits = false;
  flow.unsignedField = true;
  flow.numberOfSteps = stepsOf(options);
  flow.timeStep = timeStepOf(options);
  flow.advectionSpeed = 1.0;
  flow.advectionBalance = options.start == WrapStart::Icosphere ? 1.0 : 0.0;
  // Curvature smooths over a tenth of an element per step, and fades within an element's size.
  flow.curvatureSpeed = 0.1 * edge * edge / flow.timeStep;
  flow.curvatureRange = edge * edge;
  flow.redistribution.angle = 0.8 / flow.timeStep;
  flow.redistribution.angleMethod = AngleMethod::Shape;
  flow.solverTolerance = SolverTolerance;
  // Membranes over holes get no nearer; from close by there are none.
  flow.stallSteps = options.start == WrapStart::Icosphere ? StallSteps : 0;
  return flow;
}

} // namespace

ShrinkWrapProblem prepareShrinkWrap(
  const SurfaceMesh& mesh, const ShrinkWrapOptions& options, const Execution& execution)
{
  const auto target =
    std::make_shared<const WrapTarget>(describeTarget(mesh, options, execution.phase(0.0, 0.4)));
  const auto region = std::make_shared<const OuterRegion>(
    target->grid, target->startField, target->startLevel, execution.phase(0.4, 0.5));
  ShrinkWrapProblem problem;
  const auto reference =
    std::make_shared<const WrapReference>(*target, region, execution.phase(0.5, 0.6));
  const auto remesher = std::make_shared<WrapRemesher>(target, reference, options);
  problem.field = levelField(*target, *region, *reference, execution.phase(0.6, 0.7));
  const SurfaceMesh start = options.start == WrapStart::Icosphere
    ? sphereStart(*target)
    : region->boundary(execution.phase(0.7, 0.8));
  std::vector<double> distance;
  for (const Vec3& point : start.points)
  {
    distance.push_back(problem.field->at(point).value);
  }
  problem.start = std::make_shared<const SurfaceMesh>(
    remesher->withRightSizes(start, distance, execution.phase(0.8, 1.0)));
  problem.reference = reference;
  problem.remesher = remesher;
  problem.flow = flowFor(*target, options);
  problem.edgeLength = target->edgeLength;
  return problem;
}

} // namespace evolving
