// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ElementSizes.h"

#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceMesh.h"
#include "Remeshing/CoveringTriangles.h"
#include "Remeshing/EdgeLengthLimits.h"
#include "Remeshing/SizingField.h"
#include "Remeshing/VertexBudget.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// Of a component, and of all together when they are very many.
constexpr double LeastVertices = 100.0;
constexpr double LeastInAll = 10000.0;
/// Of the diagonal of its box, to one of those vertices: what is so much longer than wide is a
/// line, and elements of its width have no use.
constexpr double PiecesPerVertex = 2.0;

/// What of a component says how large its elements may be.
struct Extent
{
  double area = 0.0;
  Box box;

  /// The edge length of so many equilateral vertices.
  double sizeFor(double vertices) const
  {
    const double byArea = coveringEdgeLength(this->area, vertices);
    const double byLength = this->box.diagonal().norm() / (PiecesPerVertex * vertices);
    return std::max(byArea, byLength);
  }
};

std::vector<Extent> extents(const SurfaceMesh& surface, const MeshTopology& topology)
{
  std::vector<Extent> ofComponents(at(topology.componentCount()));
  for (Index f = 0; f < surface.faceCount(); ++f)
  {
    Extent& extent = ofComponents[at(topology.componentOfVertex()[at(surface.faceVertex(f, 0))])];
    extent.area += faceVectorArea(surface, f).norm();
    for (Index k = 0; k < 3; ++k)
    {
      extent.box.extend(surface.facePoint(f, k));
    }
  }
  return ofComponents;
}

/// Of every vertex the largest size on its component.
std::vector<double> largestSizes(const SurfaceMesh& surface, const MeshTopology& topology)
{
  const std::vector<Extent> ofComponents = extents(surface, topology);
  const double vertices = std::min(LeastVertices, LeastInAll / topology.componentCount());
  std::vector<double> sizes;
  for (const Index component : topology.componentOfVertex())
  {
    sizes.push_back(component == NoIndex ? 0.0 : ofComponents[at(component)].sizeFor(vertices));
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

void adaptSizes(EditableSurface& surface, double size)
{
  const double vertices = expectedVertices(surface);
  setSizesForVertexCount(
    surface, { SmallestAdaptiveSize * size, LargestAdaptiveSize * size }, vertices);
  makeUpForFlatness(surface, vertices);
}

} // namespace

void setElementSizes(
  EditableSurface& surface, double edgeLength, ElementSizing sizing, double mostVertices)
{
  const SurfaceMesh mesh = surface.mesh();
  const MeshTopology topology(mesh);
  const std::vector<double> largest = largestSizes(mesh, topology);
  setUniformSizes(surface, edgeLength);
  requireFewVertices(surface, edgeLength, mostVertices);
  limitSizes(surface, largest);
  if (sizing == ElementSizing::CurvatureAdaptive)
  {
    adaptSizes(surface, edgeLength); // as many in all, up to four times as many on needles
    limitSizes(surface, largest);
  }
}

} // namespace evolving
