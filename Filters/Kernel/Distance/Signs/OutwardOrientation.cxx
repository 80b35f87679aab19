// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/OutwardOrientation.h"

#include "Distance/Signs/ComponentNesting.h"
#include "Mesh/Angles.h"
#include "Mesh/TriangleEdges.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evolving
{

namespace
{

/// The other corner of an edge of two faces; NoIndex elsewhere.
Index partner(const TriangleEdges& edges, Index corner)
{
  const Index edge = edges.edgeOf(corner);
  if (edges.faceCount(edge) != 2)
  {
    return NoIndex;
  }
  const Index* corners = edges.begin(edge);
  return corners[0] == corner ? corners[1] : corners[0];
}

/// Components through edges of two faces, and which faces disagree with their first face.
class ConsistentTurns
{
public:
  ConsistentTurns(const SurfaceMesh& mesh, const TriangleEdges& edges)
    : Component(at(mesh.faceCount()), NoIndex)
    , Turned(at(mesh.faceCount()), 0)
  {
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      if (this->Component[at(face)] == NoIndex)
      {
        this->visitFrom(face, mesh, edges);
        ++this->Components;
      }
    }
    this->keepLargerArea(mesh);
  }

  std::vector<Index> Component;
  std::vector<char> Turned;
  Index Components = 0;

private:
  void visitFrom(Index start, const SurfaceMesh& mesh, const TriangleEdges& edges)
  {
    std::vector<Index> pending{ start };
    this->Component[at(start)] = this->Components;
    while (!pending.empty())
    {
      const Index face = pending.back();
      pending.pop_back();
      for (Index corner = 3 * face; corner < 3 * face + 3; ++corner)
      {
        const Index other = partner(edges, corner);
        if (other == NoIndex || this->Component[at(other / 3)] != NoIndex)
        {
          continue;
        }
        const bool disagree =
          TriangleEdges::runsUpwards(mesh, corner) == TriangleEdges::runsUpwards(mesh, other);
        this->Component[at(other / 3)] = this->Components;
        this->Turned[at(other / 3)] = this->Turned[at(face)] ^ static_cast<char>(disagree);
        pending.push_back(other / 3);
      }
    }
  }

  void keepLargerArea(const SurfaceMesh& mesh)
  {
    std::vector<double> kept(at(this->Components), 0.0);
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      const double area = faceVectorArea(mesh, face).norm();
      kept[at(this->Component[at(face)])] += this->Turned[at(face)] ? -area : area;
    }
    for (Index face = 0; face < mesh.faceCount(); ++face)
    {
      this->Turned[at(face)] ^= static_cast<char>(kept[at(this->Component[at(face)])] < 0.0);
    }
  }
};

/// Reverses a face, keeping its first corner.
void turn(SurfaceMesh& mesh, Index face)
{
  std::swap(mesh.cornerVertices[at(3 * face + 1)], mesh.cornerVertices[at(3 * face + 2)]);
}

/// Turns the faces marked.
void turnMarked(SurfaceMesh& mesh, TriangleEdges& edges, const std::vector<char>& marked)
{
  bool hasTurned = false;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (marked[at(face)])
    {
      turn(mesh, face);
      hasTurned = true;
    }
  }
  if (hasTurned)
  {
    edges.turn(marked);
  }
}

/// Does the volume of an open component say that its faces point inwards? A closed sphere
/// reaches 1, a flat sheet 0.
bool pointsInwards(const SurfaceComponent& component)
{
  constexpr double Clearly = 0.1;
  const double sphereVolume = std::pow(component.area, 1.5) / (6.0 * std::sqrt(Pi));
  return component.volume < -Clearly * sphereVolume;
}

/// Which components are to be turned.
std::vector<char> inwardComponents(const SurfaceMesh& mesh,
  const std::vector<SurfaceComponent>& components, const std::vector<Index>& componentOfFace)
{
  std::vector<char> inward(components.size(), 0);
  bool someClosedInward = false;
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    const bool negative = components[c].volume < 0.0;
    inward[c] = components[c].isClosed ? negative : pointsInwards(components[c]);
    someClosedInward = someClosedInward || (components[c].isClosed && negative);
  }
  if (!someClosedInward || components.size() == 1)
  {
    return inward;
  }
  const std::vector<Index> outermost = outermostEnclosing(mesh, components, componentOfFace);
  std::vector<char> byNest = inward;
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    byNest[c] = components[c].isClosed ? inward[at(outermost[c])] : inward[c];
  }
  return byNest;
}

void countEdges(const SurfaceMesh& mesh, const TriangleEdges& edges, OrientationSummary& summary)
{
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    const Index faces = edges.faceCount(edge);
    Index upwards = 0;
    for (const Index* corner = edges.begin(edge); corner != edges.end(edge); ++corner)
    {
      upwards += TriangleEdges::runsUpwards(mesh, *corner) ? 1 : -1;
    }
    summary.boundaryEdges += faces == 1 ? 1 : 0;
    summary.nonManifoldEdges += faces > 2 ? 1 : 0;
    summary.conflictingEdges += faces == 2 && upwards != 0 ? 1 : 0;
    if (upwards != 0)
    {
      const Index corner = *edges.begin(edge);
      const Index a = mesh.faceVertex(corner / 3, corner % 3);
      const Index b = mesh.faceVertex(corner / 3, (corner + 1) % 3);
      const std::array<Index, 2> along{ upwards > 0 ? std::min(a, b) : std::max(a, b),
        upwards > 0 ? std::max(a, b) : std::min(a, b) };
      summary.openLength += std::abs(upwards) * (mesh.points[at(b)] - mesh.points[at(a)]).norm();
      summary.openEdges.insert(summary.openEdges.end(), at(std::abs(upwards)), along);
    }
  }
}

} // namespace

OrientationSummary orientOutwards(SurfaceMesh& mesh)
{
  TriangleEdges edges(mesh);
  const ConsistentTurns consistent(mesh, edges);
  turnMarked(mesh, edges, consistent.Turned);
  const std::vector<SurfaceComponent> components =
    surfaceComponents(mesh, edges, consistent.Component, consistent.Components);
  const std::vector<char> inward = inwardComponents(mesh, components, consistent.Component);
  std::vector<char> turned(consistent.Turned.size());
  OrientationSummary summary;
  for (std::size_t face = 0; face < turned.size(); ++face)
  {
    turned[face] = inward[at(consistent.Component[face])];
    summary.turnedFaces += turned[face] != consistent.Turned[face] ? 1 : 0;
  }
  turnMarked(mesh, edges, turned);
  summary.components = consistent.Components;
  summary.componentsOverlap = boxesIntersect(components);
  countEdges(mesh, edges, summary);
  summary.edgeOfCorner = std::move(edges).takeEdgeOfCorner();
  return summary;
}

} // namespace evolving
