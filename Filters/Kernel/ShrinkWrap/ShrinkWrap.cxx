// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ShrinkWrap.h"

#include "Distance/SignedDistance.h"
#include "Errors.h"
#include "LostTopology/LostTopology.h"
#include "ParallelLoops.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/SizingField.h"
#include "Remeshing/TargetSamples.h"
#include "Remeshing/VertexBudget.h"
#include "ShrinkWrap/LostTopologyRemedy.h"
#include "ShrinkWrap/OuterRegion.h"
#include "ShrinkWrap/Shortcomings.h"
#include "ShrinkWrap/WantedGenus.h"
#include "ShrinkWrap/WrapLooks.h"
#include "ShrinkWrap/WrapRemesher.h"
#include "ShrinkWrap/WrapTarget.h"
#include "StartSurface/BoundingIcosphere.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// In edge lengths, about: positions need no more, for remeshing follows.
constexpr double SolverTolerance = 1e-6;
/**
 * Zero where the flow is to end: at the offset, or where sheets' walls begin; from there to the
 * target it is near enough to land. What the region contains is outside; next to the target its
 * own sides count, but not where it has sheets.
 */
std::shared_ptr<const ScalarImage> levelField(const WrapTarget& target, TargetFields fields,
  const OuterRegion& region, const WrapReference& reference)
{
  const bool hasSheets = reference.hasSheets();
  const double level = hasSheets ? std::max(target.offset, target.wall) : target.offset;
  for (std::size_t sample = 0; sample < fields.distance.size(); ++sample)
  {
    const bool isOutside = hasSheets || region.contains(sample) || !fields.isInside[sample];
    float& value = fields.distance[sample];
    value = (isOutside ? value : -value) - static_cast<float>(level);
  }
  return std::make_shared<const ScalarImage>(target.grid, std::move(fields.distance));
}

/// An isosurface has about the area that the result will have.
void requireFewAtTarget(const SurfaceMesh& start, const WrapTarget& target)
{
  EditableSurface surface(start);
  setSizesAround(surface, target);
  requireFewVertices(surface, target.edgeLength);
}

/// A grid of cells far larger than the target may have no sample inside the start level.
void requireFaces(const SurfaceMesh& start, const WrapTarget& target, double gapSize)
{
  if (start.faceCount() > 0)
  {
    return;
  }
  std::ostringstream message;
  message
    << "SampleDimensions and a GapSize of " << gapSize << " give cells of " << target.cellSize()
    << " that do not see the input, which is " << target.box.sizes().maxCoeff()
    << " long, expected cells smaller than the input; set a smaller GapSize, or more samples.";
  throw InputError(message.str());
}

/// A sphere around the target, of few triangles: withRightSizes() makes them as small as the
/// distance asks for. The margin keeps it off the target where that is a sphere itself.
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
  const FlowTuning& tuning = target.tuning.flow;
  const double edge = target.shortestEdge();
  FlowOptions flow;
  flow.relativeUnits = false;
  flow.unsignedField = true;
  flow.numberOfSteps = stepsOf(options);
  flow.timeStep = timeStepOf(options);
  flow.advectionSpeed = 1.0;
  flow.longestAdvection = tuning.longestAdvection;
  // Curvature fades within an element's size of the target.
  flow.curvatureSpeed = tuning.curvaturePerStep * edge * edge / flow.timeStep;
  flow.curvatureRange = edge * edge;
  flow.redistribution.angle = tuning.anglePerStep / flow.timeStep;
  flow.redistribution.angleMethod = AngleMethod::Shape;
  flow.solverTolerance = SolverTolerance;
  if (options.start == WrapStart::Icosphere)
  {
    flow.advectionBalance = tuning.sphereBalance;
    flow.curvatureSpeed = tuning.sphereCurvaturePerStep * edge * edge / flow.timeStep;
    const double size = 0.5 * target.box.diagonal().norm();
    flow.convergenceTolerance = tuning.arrivedEdges * edge / (size * flow.timeStep); // in a step
    flow.stallSteps = tuning.stallSteps;
  }
  return flow;
}

} // namespace

int wrapBytesPerSample()
{
  constexpr int Distance = 4;
  constexpr int Inside = 1;
  constexpr int Boundary = 6; // its triangles and their tree, measured
  return Distance + Inside + peakBytesPerSample({}) + Boundary;
}

ShrinkWrapProblem prepareShrinkWrap(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const Execution& execution, const WrapTuning& tuning)
{
  const SeenTarget seen = lookAsNeeded(mesh, options, tuning, execution.phase(0.0, 0.6));
  const std::shared_ptr<const WrapTarget> target = seen.view->target();
  const std::shared_ptr<const WrapReference> reference = seen.view->reference();
  const OuterRegion& region = seen.view->region();
  ShrinkWrapProblem problem;
  const auto remesher = std::make_shared<WrapRemesher>(target, reference, options);
  problem.field = levelField(*target, std::move(seen.view->fields()), region, *reference);
  const SurfaceMesh start = options.start == WrapStart::Icosphere
    ? sphereStart(*target)
    : region.boundary(execution.phase(0.7, 0.8));
  if (options.start == WrapStart::Isosurface)
  {
    requireFaces(start, *target, options.gapSize);
    requireFewAtTarget(start, *target);
  }
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
  problem.modelSize = target->modelSize();
  problem.target = target;
  problem.options = options;
  problem.keepsTopology = mesh.faceCount() > 0 && keepsTopology(options);
  return problem;
}

std::size_t bytesOf(const ShrinkWrapProblem& problem)
{
  return problem.field->values().size() * sizeof(float) + problem.reference->bytes();
}

SurfaceReport measureWrap(
  const SurfaceMesh& surface, const ShrinkWrapProblem& problem, const Execution& execution)
{
  const WrapReference& reference = *problem.reference;
  SurfaceReport report = examine(
    surface, [&reference](const Vec3& p) { return reference.deviation(p); },
    execution.phase(0.0, 0.75));
  const double far = farDistance(problem.edgeLength, problem.modelSize) + reference.highestLevel();
  measureLoss(surface, samplesOf(reference.visible(), problem.edgeLength), far, report,
    execution.phase(0.75, 1.0));
  report.creases = problem.remesher->creases();
  report.adaptation = problem.remesher->adaptation();
  report.coarse = findCoarseParts(surface);
  report.modelSize = problem.modelSize;
  report.morePoints = problem.options.targetEdgeLength == 0.0
    ? std::min(2 * surface.vertexCount(), Index(MostPointsToAskFor))
    : 0;
  return report;
}

SurfaceReport examineWrap(
  const SurfaceMesh& surface, const ShrinkWrapProblem& problem, const Execution& execution)
{
  SurfaceReport report = measureWrap(surface, problem, execution.phase(0.0, 0.8));
  if (problem.keepsTopology)
  {
    report.lost = findLostTopology(
      problem.target->surface, surface, problem.edgeLength, execution.phase(0.8, 1.0));
  }
  if (report.lost)
  {
    report.lost->remedy = remedyFor(*report.lost, *problem.target, problem.options);
  }
  return report;
}

} // namespace evolving
