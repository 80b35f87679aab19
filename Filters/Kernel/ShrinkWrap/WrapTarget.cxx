// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/WrapTarget.h"

#include "Distance/SignedDistance.h"
#include "Errors.h"
#include "Mesh/SeamWelding.h"
#include "Mesh/TopologySummary.h"
#include "Remeshing/SizingField.h"
#include "ShrinkWrap/PointSurface.h"
#include "ShrinkWrap/TightGrid.h"
#include "StartSurface/GapClosing.h"
#include "StartSurface/HoleChoice.h"
#include "StartSurface/HoleFilling.h"
#include "StartSurface/InsideSamples.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace evolving
{

namespace
{

/// Of the squared diagonal: faces on a line far from the origin have as much by rounding.
constexpr double LeastArea = 1e-12;

/// Beyond the start surface a flow from it needs no distances, but differences at it do.
constexpr double DistanceCells = 3.0;
constexpr double EverywhereIsNear = 0.0; ///< SignedDistanceOptions::bandWidth

void requireExtent(const Box& box)
{
  if (box.isEmpty() || !(box.diagonal().norm() > 0.0))
  {
    throw InputError("The input is a single point or empty, expected a surface or points with an "
                     "extent; check the file.");
  }
}

/// Triangles with longer edges than half the diagonal of a model cannot have its shape.
void requireShortEdges(const WrapTarget& target)
{
  constexpr double LongestEdge = 0.5;
  constexpr double GoodEdge = 1.0 / 30.0; // what SurfaceReport.h calls far is two of these
  const double size = target.modelSize();
  if (target.edgeLength > LongestEdge * size)
  {
    std::ostringstream message;
    message << "TargetEdgeLength is " << target.edgeLength << ", expected at most "
            << LongestEdge * size
            << ", half the diagonal of the model, to get a surface of its shape; set "
            << GoodEdge * size << ", or 0 for an automatic one.";
    throw InputError(message.str());
  }
}

/// Sides, and so walls, follow from the faces' normals.
void requireArea(const WrapTarget& target)
{
  if (!(target.area > LeastArea * target.box.diagonal().squaredNorm()))
  {
    throw InputError("The input has no area, expected faces that are not all degenerate; repair "
                     "it, or remove the faces to wrap its points.");
  }
}

/// Signs only where they are sure and cheap.
SignMethod signFor(const SurfaceMesh& surface)
{
  const TopologySummary topology = summarizeTopology(surface);
  const bool isSure = topology.isClosed() && topology.isManifold() && topology.components == 1;
  return isSure ? SignMethod::Pseudonormal : SignMethod::Unsigned;
}

std::vector<float> distanceTo(
  const SurfaceMesh& surface, const DistanceGrid& grid, double reach, const Execution& execution)
{
  SignedDistanceOptions options;
  options.sign = signFor(surface);
  options.bandWidth = reach / grid.spacing.maxCoeff();
  return signedDistance(surface, grid, grid.extent, options, execution).distance;
}

/// Takes signs apart from distances: a bit each.
void splitSigns(std::vector<float> signedDistance, TargetFields& fields)
{
  fields.isInside.resize(signedDistance.size());
  for (std::size_t sample = 0; sample < signedDistance.size(); ++sample)
  {
    fields.isInside[sample] = std::signbit(signedDistance[sample]);
    signedDistance[sample] = std::abs(signedDistance[sample]);
  }
  fields.distance = std::move(signedDistance);
}

/// The volume that a ball of a diameter cannot come into, beside what it touches.
double enclosedBy(const DistanceGrid& grid, const std::vector<float>& distance, double diameter,
  const Execution& execution)
{
  InsideSamples samples(grid, distance, 0.5 * diameter, execution);
  return static_cast<double>(fillCavities(samples, execution)) * grid.spacing.prod();
}

/**
 * The smallest gap to close for which the target has the inside that it has for larger ones: what
 * the start level lets in by a crack, as beside a lid, is meant to be inside.
 */
double gapThatCloses(
  const WrapTarget& target, const std::vector<float>& distance, const Execution& execution)
{
  const TargetTuning& tuning = target.tuning.target;
  const double least = 2.0 * target.startLevel;
  const double most = least + tuning.largestCrackEdges * target.edgeLength;
  const double enclosed = enclosedBy(target.grid, distance, most, execution);
  double gap = least;
  while (
    gap < most && enclosedBy(target.grid, distance, gap, execution) < tuning.closedPart * enclosed)
  {
    gap += tuning.crackStepEdges * target.edgeLength;
  }
  return gap < most ? gap : (enclosed > 0.0 ? most : least);
}

ShrinkWrapOptions sampled(ShrinkWrapOptions options, const WrapResolution& resolution)
{
  options.sampleDimensions = resolution.samples;
  return options;
}

SurfaceMesh withoutHoles(
  const SurfaceMesh& surface, double gapSize, double narrow, const Execution& execution)
{
  const std::vector<BoundaryLoop> loops = boundaryLoops(surface);
  return fillHoles(surface, holesToFill(surface, loops, gapSize, narrow), execution);
}

} // namespace

void setSizesAround(EditableSurface& surface, const WrapTarget& target)
{
  if (!target.besideCreases)
  {
    setUniformSizes(surface, target.elementSize());
    return;
  }
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v))
    {
      surface.setSize(v, target.elementSizeAt(surface.point(v)));
    }
  }
  gradeSizes(surface, target.besideCreases->growth());
}

DescribedTarget describeTarget(const SurfaceMesh& mesh, const ShrinkWrapOptions& options,
  const WrapResolution& resolution, const Execution& execution, const WrapTuning& tuning)
{
  checkOptions(options);
  validate(mesh);
  DescribedTarget described;
  WrapTarget& target = described.target;
  TargetFields& fields = described.fields;
  target.tuning = tuning;
  const TargetTuning& lengths = tuning.target;
  target.box = boundingBox(mesh);
  requireExtent(target.box);
  const bool isPointSet = mesh.faceCount() == 0;
  target.surface = isPointSet
    ? surfaceAmidst(mesh, sampled(options, resolution), execution.phase(0.0, 0.4), tuning.points)
    : weldSeams(weldCoincidentPoints(mesh), roundingOf(mesh));
  target.area = surfaceArea(target.surface);
  target.offset = options.offsetDistance;
  target.edgeLength = resolution.edgeLength > 0.0
    ? resolution.edgeLength
    : defaultEdgeLength(target.area, target.box.diagonal().norm());
  target.besideCreases = resolution.beside;
  requireArea(target);
  requireShortEdges(target);
  const double gap = isPointSet ? 0.0 : options.gapSize;
  target.surface = withoutHoles(
    target.surface, gap, lengths.narrowEdges * target.edgeLength, execution.phase(0.4, 0.5));
  target.wall = target.wallFor(target.edgeLength);
  const double room =
    target.offset + std::max(lengths.largestCrackEdges * target.edgeLength, 0.5 * gap);
  target.grid = tightGrid(target.box, resolution.samples, room);
  target.startLevel = target.offset +
    std::max(
      lengths.startPerEdge * target.shortestEdge(), lengths.startPerCell * target.cellSize());
  const double needed = room + DistanceCells * target.cellSize();
  const double reach = options.start == WrapStart::Isosurface ? needed : EverywhereIsNear;
  splitSigns(distanceTo(target.surface, target.grid, reach, execution.phase(0.5, 0.8)), fields);
  const double closed =
    gap > 0.0 ? gap : gapThatCloses(target, fields.distance, execution.phase(0.8, 0.8));
  fields.start =
    closeGaps(target.grid, fields.distance, target.startLevel, closed, execution.phase(0.8, 1.0));
  return described;
}

} // namespace evolving
