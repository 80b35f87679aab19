// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceRemesher.h"

#include "Errors.h"
#include "Evolution/DegenerateElements.h"
#include "Evolution/ElementRenewal.h"
#include "Evolution/LevelReference.h"
#include "Evolution/NeckSurgery.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/PolygonTriangulation.h"
#include "Mesh/SelfIntersections.h"
#include "ParallelLoops.h"
#include "ParameterRange.h"
#include "Redistribution/VanishedComponents.h"
#include "Remeshing/CoveringTriangles.h"
#include "Remeshing/CurvedReference.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/VertexBudget.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// Two are enough for all but threads that begin with many points around.
constexpr int NeckRounds = 3;
/// Elements of large surfaces may be renewed, and made finer within reason.
constexpr double MostFiner = 4.0;
/// Before edges collapse there may be that many times as many.
constexpr double OnTheWay = 2.0;
/// Of a boundary that must keep its shape, in sizes: rounding of vertices in a straight line.
constexpr double StraightCut = 1e-6;

double smallestComponentOf(const SurfaceMesh& start, const SurfaceRemeshingOptions& options)
{
  if (!options.onlyDegenerate && !start.hasOnlyTriangles())
  {
    throw InputError("The start surface has faces that are not triangles, expected triangles only "
                     "where it is remeshed.");
  }
  const MeshTopology topology(start);
  return VanishedComponents(start, topology).smallestStartArea();
}

/// Without the components that have shrunk to points; all when no other is left.
SurfaceMesh withoutVanished(const RemeshingInput& input, double smallestComponent)
{
  const MeshTopology topology(input.surface);
  SurfaceMesh before = input.surface;
  before.points = input.before;
  VanishedComponents vanished(before, topology, smallestComponent);
  vanished.update(input.surface);
  SurfaceMesh rest;
  rest.points = input.surface.points;
  for (Index f = 0; f < input.surface.faceCount(); ++f)
  {
    if (!vanished.contain(input.surface.faceVertex(f, 0)))
    {
      rest.addFace({ input.surface.faceVertex(f, 0), input.surface.faceVertex(f, 1),
        input.surface.faceVertex(f, 2) });
    }
  }
  return rest.faceCount() > 0 ? rest : input.surface;
}

} // namespace

void checkOptions(const SurfaceRemeshingOptions& options)
{
  // Squares of lengths in this range, and their quotients, are numbers.
  constexpr double Smallest = 1e-100;
  constexpr double Largest = 1e100;
  checkRangeOrZero("TargetEdgeLength", options.edgeLength, Smallest, Largest,
    "0 means the mean of the input's edges");
}

SurfaceRemesher::SurfaceRemesher(const SurfaceMesh& start, const SurfaceRemeshingOptions& options)
  : Options(options)
  , SmallestComponent(smallestComponentOf(start, options))
{
  checkOptions(options);
  if (options.onlyDegenerate)
  {
    this->StartCorners = start.cornerVertices;
  }
  // Needles, as CAD programs make them, have a mean that is much too large.
  if (options.onlyDegenerate || options.targetArea > 0.0)
  {
    this->Vertices = wantedVertices(start);
  }
  else if (!(options.edgeLength > 0.0))
  {
    this->Options.edgeLength = meanEdgeLength(start);
  }
}

double SurfaceRemesher::edgeLength(const SurfaceMesh& surface) const
{
  if (this->Options.edgeLength > 0.0)
  {
    return this->Options.edgeLength;
  }
  const double area = surfaceArea(surface);
  return this->Options.onlyDegenerate
    ? coveringEdgeLength(area, this->Vertices)
    : std::max(coveringEdgeLength(this->Options.targetArea, this->Vertices),
        coveringEdgeLength(area, LargestPerTarget * this->Vertices));
}

/// Of a start like a box of eight corners, that is to become anything else.
bool SurfaceRemesher::isTooCoarse(const SurfaceMesh& surface) const
{
  return isCoarse(surface, coveringVertexCount(surfaceArea(surface), this->edgeLength(surface)));
}

/// Elements that have been made anew are not what anybody asked to keep.
bool SurfaceRemesher::hasStartElements(const SurfaceMesh& surface) const
{
  return surface.cornerVertices == this->StartCorners;
}

/// What the flow rounds off is its start; edges that it ends with are its target's.
bool SurfaceRemesher::mayStay(const RemeshingInput& input) const
{
  const bool areAsked =
    this->hasStartElements(input.surface) ? this->Options.keepsStart : !input.isLast;
  if (!this->Options.onlyDegenerate || !areAsked)
  {
    return false;
  }
  const bool hasField = !input.distance.empty();
  if (hasField && this->isTooCoarse(input.surface))
  {
    return false;
  }
  const bool mayBeCreased = !hasField || !input.isLast;
  return !hasDegenerateElements(input.surface, this->Options.boundaryMode,
    mayBeCreased ? this->edgeLength(input.surface) : 0.0);
}

/// Elements of the start on a target with sharp edges, which new ones would make saws of.
bool SurfaceRemesher::isCreasedEnd(const RemeshingInput& input) const
{
  return this->Options.onlyDegenerate && this->Options.keepsStart && input.isLast &&
    this->hasStartElements(input.surface) && !this->isTooCoarse(input.surface) &&
    !hasDegenerateElements(
      input.surface, this->Options.boundaryMode, this->edgeLength(input.surface));
}

std::optional<SurfaceMesh> SurfaceRemesher::remesh(
  const RemeshingInput& input, const Execution& execution)
{
  if (this->mayStay(input))
  {
    return std::nullopt;
  }
  std::vector<Index> oldFace;
  const bool isReady = input.surface.hasOnlyTriangles();
  const SurfaceMesh triangles =
    isReady ? SurfaceMesh() : triangulate(input.surface, oldFace, execution.phase(0.0, 0.0));
  const SurfaceMesh& surface = isReady ? input.surface : triangles;
  const RemeshingInput cut = { surface, input.before, input.distance, input.isLast, input.target };
  if (isReady && this->isCreasedEnd(input))
  {
    SurfaceMesh repaired = withWorstAnglesMoved(input.surface, execution);
    if (!hasDegenerateElements(repaired, this->Options.boundaryMode, 0.0))
    {
      return repaired;
    }
  }
  std::optional<SurfaceMesh> made = this->remeshTriangles(cut, execution);
  // What still is not good is a neck that is thin enough to be cut only now.
  const bool mayHaveNecks = this->Options.onlyDegenerate && input.distance.empty();
  for (int round = 0; mayHaveNecks && round < NeckRounds &&
       hasDegenerateElements(*made, this->Options.boundaryMode, this->edgeLength(*made));
       ++round)
  {
    const SurfaceMesh again = *made;
    made =
      this->remeshTriangles({ again, again.points, input.distance, input.isLast, input.target },
        execution.phase(1.0, 1.0));
  }
  return made;
}

std::optional<SurfaceMesh> SurfaceRemesher::remeshTriangles(
  const RemeshingInput& input, const Execution& execution)
{
  SurfaceMesh rest = withoutVanished(input, this->SmallestComponent);
  if (this->Options.onlyDegenerate && input.distance.empty())
  {
    rest = withNecksCut(rest, this->edgeLength(rest));
  }
  EditableSurface surface(rest);
  surface.compact();
  const SurfaceMesh evolved = surface.mesh();
  const double mostVertices = std::max(MostVertices, MostFiner * evolved.vertexCount());
  setElementSizes(surface, this->edgeLength(evolved), this->Options.sizing, mostVertices);
  const bool isWhole = evolved.faceCount() == input.surface.faceCount();
  const bool mayStay = !input.isLast && !this->Options.onlyDegenerate;
  if (isWhole && mayStay && hasGoodElements(surface, evolved))
  {
    return std::nullopt;
  }
  const Execution now = execution.phase(0.0, 0.0); // parts may run again
  const CurvedReference reference(evolved, now);
  RemeshingOptions options;
  options.mostVertices = OnTheWay * mostVertices;
  if (this->Options.boundaryMode != BoundaryMode::Free)
  {
    options.guards.deepestCut = StraightCut;
  }
  // What is made anew once in a while is made as good as can be, to stay so for long.
  const bool isThorough = input.isLast || this->Options.onlyDegenerate;
  const auto levels = input.isLast && input.target
    ? std::make_unique<const LevelReference>(*input.target, input.surface, input.distance, now)
    : nullptr;
  const auto stage = [&](EditableSurface& s)
  { renewElements(s, reference, levels.get(), options, isThorough, now); };
  if (selfIntersections(evolved, now).empty())
  {
    runWithoutIntersections(surface, stage, now);
  }
  else
  {
    stage(surface);
  }
  return surface.mesh();
}

} // namespace evolving
