// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceRemesher.h"

#include "Errors.h"
#include "Mesh/MeshQuality.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SelfIntersections.h"
#include "ParallelLoops.h"
#include "ParameterRange.h"
#include "Redistribution/VanishedComponents.h"
#include "Remeshing/CurvedReference.h"
#include "Remeshing/EdgeLengthLimits.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/IntersectionFreeStages.h"
#include "Remeshing/Remeshing.h"
#include "Remeshing/SizingField.h"
#include "Remeshing/StarOptimization.h"
#include "Remeshing/VertexBudget.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

constexpr double LeastVertices = 100.0; ///< of a component
/// Good elements stay between steps: none with a smaller angle, in degrees, and no more edges than
/// this part too short or too long.
constexpr double GoodAngle = 30.0;
constexpr double FewEdges = 0.01;
/// Passes between steps, which the next ones go on from, and where the run ends.
constexpr int Passes = 2;
constexpr int LastPasses = 5;
constexpr int PolishPasses = 2;
/// At the end smallest angles up to this are worth a search, in degrees; and how many rounds of it.
constexpr double WantedAngle = 40.0;
constexpr int StarRounds = 3;
/// Elements of large surfaces may be renewed, and made finer within reason.
constexpr double MostFiner = 4.0;
/// Of a boundary that must keep its shape, in sizes: rounding of vertices in a straight line.
constexpr double StraightCut = 1e-6;

double smallestComponentOf(const SurfaceMesh& start)
{
  if (!start.hasOnlyTriangles())
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

/// Of every vertex the edge length of LeastVertices equilateral vertices on its component.
std::vector<double> largestSizes(const SurfaceMesh& surface)
{
  const MeshTopology topology(surface);
  std::vector<double> areas(at(topology.componentCount()), 0.0);
  for (Index f = 0; f < surface.faceCount(); ++f)
  {
    areas[at(topology.componentOfVertex()[at(surface.faceVertex(f, 0))])] +=
      faceVectorArea(surface, f).norm();
  }
  std::vector<double> sizes(surface.points.size(), 0.0);
  for (std::size_t v = 0; v < sizes.size(); ++v)
  {
    const Index component = topology.componentOfVertex()[v];
    const double area = component == NoIndex ? 0.0 : areas[at(component)];
    sizes[v] = std::sqrt(2.0 * area / (std::sqrt(3.0) * LeastVertices));
  }
  return sizes;
}

void limitSizes(EditableSurface& surface, const std::vector<double>& largest)
{
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    surface.setSize(v, std::min(surface.size(v), largest[at(v)]));
  }
}

/// Where most of a surface is flat, and its elements largest, there are fewer vertices than wanted.
void makeUpForFlatness(EditableSurface& surface, double vertices)
{
  const double factor = std::min(1.0, std::sqrt(expectedVertices(surface) / vertices));
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    surface.setSize(v, factor * surface.size(v));
  }
}

void setSizes(
  EditableSurface& surface, const std::vector<double>& largest, double size, ElementSizing sizing)
{
  setUniformSizes(surface, size);
  limitSizes(surface, largest);
  if (sizing == ElementSizing::CurvatureAdaptive)
  {
    const double vertices = expectedVertices(surface);
    setSizesForVertexCount(
      surface, { SmallestAdaptiveSize * size, LargestAdaptiveSize * size }, vertices);
    makeUpForFlatness(surface, vertices);
    limitSizes(surface, largest);
  }
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
  const RemeshingOptions& options, bool isLast, const Execution& execution)
{
  for (int pass = 0; pass < (isLast ? LastPasses : Passes); ++pass)
  {
    remeshOnce(surface, reference, options, execution);
  }
  if (isLast)
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
  , SmallestComponent(smallestComponentOf(start))
{
  checkOptions(options);
  if (!(options.edgeLength > 0.0))
  {
    this->Options.edgeLength = meanEdgeLength(start);
  }
}

std::optional<SurfaceMesh> SurfaceRemesher::remesh(
  const RemeshingInput& input, const Execution& execution)
{
  EditableSurface surface(withoutVanished(input, this->SmallestComponent));
  surface.compact();
  const SurfaceMesh evolved = surface.mesh();
  setSizes(surface, largestSizes(evolved), this->Options.edgeLength, this->Options.sizing);
  requireFewVertices(
    surface, this->Options.edgeLength, std::max(MostVertices, MostFiner * evolved.vertexCount()));
  const bool isWhole = evolved.faceCount() == input.surface.faceCount();
  if (isWhole && !input.isLast && hasGoodElements(surface, evolved))
  {
    return std::nullopt;
  }
  const Execution now = execution.phase(0.0, 0.0); // parts may run again
  const CurvedReference reference(evolved, now);
  RemeshingOptions options;
  if (this->Options.boundaryMode != BoundaryMode::Free)
  {
    options.guards.deepestCut = StraightCut;
  }
  const auto stage = [&](EditableSurface& s) { renew(s, reference, options, input.isLast, now); };
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
