// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceRemesher.h"

#include "Errors.h"
#include "Evolution/DegenerateElements.h"
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
#include "Remeshing/EdgeLengthLimits.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/StarOptimization.h"
#include "Remeshing/VertexBudget.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// Good elements stay between steps: none with a smaller angle, in degrees, and no more edges than
/// this part too short or too long.
constexpr double GoodAngle = 30.0;
constexpr double FewEdges = 0.01;
/// Passes between steps, which the next ones go on from, and where the flow ends.
constexpr int Passes = 2;
constexpr int LastPasses = 5;
constexpr int PolishPasses = 2;
/// Two are enough for all but threads that begin with many points around.
constexpr int NeckRounds = 3;
/// At the end smallest angles up to this are worth a search, in degrees; and how many rounds of it.
constexpr double WantedAngle = 40.0;
constexpr int StarRounds = 3;
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

bool hasGoodElements(const EditableSurface& surface, const SurfaceMesh& mesh)
{
  Index edges = 0;
  Index badEdges = 0;
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    if (surface.isFirstHalf(e))
    {
      const double length = surface.length(e) / surface.size(surface.from(e), surface.to(e));
      badEdges += length < ShortestGoodPerSize || length > LongestGoodPerSize ? 1 : 0;
      ++edges;
    }
  }
  return badEdges <= FewEdges * edges && smallestAngle(mesh) >= GoodAngle;
}

void renew(EditableSurface& surface, const ReferenceSurface& reference,
  const RemeshingOptions& options, bool isThorough, const Execution& execution)
{
  for (int pass = 0; pass < (isThorough ? LastPasses : Passes); ++pass)
  {
    remeshOnce(surface, reference, options, execution);
  }
  if (isThorough)
  {
    for (int pass = 0; pass < PolishPasses; ++pass)
    {
      polishOnce(surface, reference, options, execution);
    }
    optimizeStars(surface, reference, WantedAngle, StarRounds, execution);
  }
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
    this->Vertices = wantedVertices(start);
    this->StartCorners = start.cornerVertices;
  }
  else if (!(options.edgeLength > 0.0))
  {
    this->Options.edgeLength = meanEdgeLength(start);
  }
}

/// Needles, as CAD programs make them, have a mean that is much too large.
double SurfaceRemesher::edgeLength(const SurfaceMesh& surface) const
{
  return this->Options.edgeLength > 0.0 ? this->Options.edgeLength
                                        : coveringEdgeLength(surfaceArea(surface), this->Vertices);
}

/// Elements that have been made anew are not what anybody asked to keep.
bool SurfaceRemesher::hasStartElements(const SurfaceMesh& surface) const
{
  return surface.cornerVertices == this->StartCorners;
}

std::optional<SurfaceMesh> SurfaceRemesher::remesh(
  const RemeshingInput& input, const Execution& execution)
{
  const bool mayStay =
    this->hasStartElements(input.surface) ? this->Options.keepsStart : !input.isLast;
  if (this->Options.onlyDegenerate && mayStay &&
    !hasDegenerateElements(
      input.surface, this->Options.boundaryMode, this->edgeLength(input.surface)))
  {
    return std::nullopt;
  }
  std::vector<Index> oldFace;
  const bool isReady = input.surface.hasOnlyTriangles();
  const SurfaceMesh triangles =
    isReady ? SurfaceMesh() : triangulate(input.surface, oldFace, execution.phase(0.0, 0.0));
  const SurfaceMesh& surface = isReady ? input.surface : triangles;
  std::optional<SurfaceMesh> made =
    this->remeshTriangles({ surface, input.before, input.distance, input.isLast }, execution);
  // What still is not good is a neck that is thin enough to be cut only now.
  const bool mayHaveNecks = this->Options.onlyDegenerate && input.distance.empty();
  for (int round = 0; mayHaveNecks && round < NeckRounds &&
       hasDegenerateElements(*made, this->Options.boundaryMode, this->edgeLength(*made));
       ++round)
  {
    const SurfaceMesh again = *made;
    made = this->remeshTriangles(
      { again, again.points, input.distance, input.isLast }, execution.phase(1.0, 1.0));
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
  const auto stage = [&](EditableSurface& s) { renew(s, reference, options, isThorough, now); };
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
