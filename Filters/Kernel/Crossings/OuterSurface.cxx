// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/OuterSurface.h"

#include "Crossings/CutTriangles.h"
#include "Crossings/SeparateSheets.h"
#include "Crossings/SeparatedParts.h"
#include "Distance/Signs/OutwardOrientation.h"
#include "Distance/Signs/WindingNumber.h"
#include "Mesh/DisjointSets.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/SurfaceParts.h"
#include "Mesh/TopologySummary.h"
#include "Mesh/TriangleEdges.h"
#include "ParallelLoops.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace evolving
{

namespace
{

/// Which pieces lie inside closed parts.
class CoveredPieces
{
public:
  /// @param whole before it was cut. All must outlive this
  CoveredPieces(const SurfaceMesh& whole, const SurfaceParts& parts, const CutTriangles& cut,
    const Execution& execution)
    : Whole(whole)
    , Parts(parts)
    , Cut(cut)
    , Winding(trianglesOfClosedParts(whole, parts), execution)
  {
  }

  /// A piece that was not cut where it should be is covered only if all of it is.
  bool isCovered(Index piece) const
  {
    const Triangle t = triangleOf(this->Cut.mesh, piece);
    const Vec3 middle = (t.corners[0] + t.corners[1] + t.corners[2]) / 3.0;
    const Index triangle = this->Cut.oldFace[at(piece)];
    constexpr double TowardsCorner = 0.9;
    return this->isInside(middle, triangle) &&
      std::all_of(t.corners.begin(), t.corners.end(),
        [&](const Vec3& corner)
        { return this->isInside(middle + TowardsCorner * (corner - middle), triangle); });
  }

private:
  static std::vector<Triangle> trianglesOfClosedParts(
    const SurfaceMesh& whole, const SurfaceParts& parts)
  {
    std::vector<Triangle> triangles;
    for (Index face = 0; face < whole.faceCount(); ++face)
    {
      if (parts.list[at(parts.ofFace[at(face)])].isClosed)
      {
        triangles.push_back(triangleOf(whole, face));
      }
    }
    return triangles;
  }

  /// Of a point on a triangle: the other triangles of its part, when that is closed, wind round it
  /// by half, for on one side of it is the inside.
  bool isInside(const Vec3& point, Index triangle) const
  {
    const double all = this->Winding.at(point);
    return this->Parts.list[at(this->Parts.ofFace[at(triangle)])].isClosed
      ? all - windingNumber(triangleOf(this->Whole, triangle), point) > 1.0
      : all > 0.5;
  }

  const SurfaceMesh& Whole;
  const SurfaceParts& Parts;
  const CutTriangles& Cut;
  WindingNumber Winding;
};

/// Of the diagonal: a few times what parts are moved by.
constexpr double ShortestEdge = 3e-6;
/// A triangle of open parts may cross so many others of such, on average: in a soup of large ones
/// all cross all, and pieces would be smaller than any element.
constexpr std::size_t MostCrossings = 4;

/// Without those of open parts where these are a soup.
std::vector<IndexPair> worthCutting(const SurfaceParts& parts, const std::vector<IndexPair>& pairs)
{
  const auto isOpen = [&parts](Index face)
  { return !parts.list[at(parts.ofFace[at(face)])].isClosed; };
  std::size_t openFaces = 0;
  for (Index face = 0; face < static_cast<Index>(parts.ofFace.size()); ++face)
  {
    openFaces += isOpen(face) ? 1 : 0;
  }
  std::vector<IndexPair> ofClosed;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(ofClosed),
    [&isOpen](const IndexPair& pair) { return !isOpen(pair.first) || !isOpen(pair.second); });
  return pairs.size() - ofClosed.size() > MostCrossings * openFaces ? ofClosed : pairs;
}

/// Of every piece, for itself.
std::vector<char> coveredPieces(const SurfaceMesh& whole, const SurfaceParts& parts,
  const CutTriangles& cut, const Execution& execution)
{
  const CoveredPieces covered(whole, parts, cut, execution.phase(0.0, 0.3));
  std::vector<char> isCovered(at(cut.mesh.faceCount()), 0);
  execution.phase(0.3, 1.0).forRangeReporting(cut.mesh.faceCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto piece = static_cast<Index>(begin); piece < static_cast<Index>(end); ++piece)
      {
        isCovered[at(piece)] = covered.isCovered(piece);
      }
    });
  return isCovered;
}

/// What crosses nothing is covered as a whole or not at all: slivers, of which rounding decides,
/// follow the others. Where pieces are as large and do not agree a crossing was not cut.
void letPatchesAgree(const SurfaceMesh& pieces, std::vector<char>& isCovered)
{
  constexpr double Sliver = 0.01; // of a patch
  const TriangleEdges edges(pieces);
  DisjointSets patches(at(pieces.faceCount()));
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    if (edges.faceCount(edge) == 2)
    {
      patches.join(edges.begin(edge)[0] / 3, edges.begin(edge)[1] / 3);
    }
  }
  std::vector<double> area(at(pieces.faceCount()), 0.0);
  std::vector<double> covered(at(pieces.faceCount()), 0.0);
  for (Index piece = 0; piece < pieces.faceCount(); ++piece)
  {
    const auto patch = at(patches.find(piece));
    const double size = faceVectorArea(pieces, piece).norm();
    area[patch] += size;
    covered[patch] += isCovered[at(piece)] != 0 ? size : 0.0;
  }
  for (Index piece = 0; piece < pieces.faceCount(); ++piece)
  {
    const auto patch = at(patches.find(piece));
    if (covered[patch] <= Sliver * area[patch])
    {
      isCovered[at(piece)] = 0;
    }
    else if (covered[patch] >= (1.0 - Sliver) * area[patch])
    {
      isCovered[at(piece)] = 1;
    }
  }
}

/// Contacts leave edges as short as parts were moved, along which no crease can be told. They are
/// collapsed, unless that would pinch the surface.
SurfaceMesh withoutShortEdges(const SurfaceMesh& surface, double length)
{
  const TriangleEdges edges(surface);
  DisjointSets same(at(surface.vertexCount()));
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    const Index corner = *edges.begin(edge);
    const Index a = surface.cornerVertices[at(corner)];
    const Index b = surface.cornerVertices[at(TriangleEdges::nextCorner(corner))];
    if ((surface.points[at(a)] - surface.points[at(b)]).norm() < length)
    {
      same.join(a, b);
    }
  }
  SurfaceMesh joined = surface;
  for (Index& vertex : joined.cornerVertices)
  {
    vertex = same.find(vertex);
  }
  joined = weldCoincidentPoints(joined);
  const bool isPinched =
    summarizeTopology(surface).isClosed() && !summarizeTopology(joined).isClosed();
  return isPinched ? surface : joined;
}

SurfaceMesh withoutCovered(const SurfaceMesh& whole, const SurfaceParts& parts,
  const CutTriangles& cut, const Execution& execution)
{
  std::vector<char> isCovered = coveredPieces(whole, parts, cut, execution);
  letPatchesAgree(cut.mesh, isCovered);
  SurfaceMesh outer;
  outer.points = cut.mesh.points;
  for (Index piece = 0; piece < cut.mesh.faceCount(); ++piece)
  {
    if (isCovered[at(piece)] == 0)
    {
      outer.addFace({ cut.mesh.faceVertex(piece, 0), cut.mesh.faceVertex(piece, 1),
        cut.mesh.faceVertex(piece, 2) });
    }
  }
  return weldCoincidentPoints(outer);
}

} // namespace

std::optional<SurfaceMesh> outerSurface(const SurfaceMesh& surface, const Execution& execution)
{
  SurfaceMesh whole = separateSheets(surface);
  const std::vector<IndexPair> meeting =
    selfIntersections(triangleView(whole), execution.phase(0.0, 0.2));
  if (meeting.empty())
  {
    return std::nullopt;
  }
  orientOutwards(whole);
  const SurfaceParts parts = surfaceParts(whole);
  const std::vector<Vec3> separated = separatedPoints(whole, parts, meeting);
  const bool isSeparated = separated != whole.points;
  whole.points = separated;
  const std::vector<IndexPair> crossing =
    isSeparated ? selfIntersections(triangleView(whole), execution.phase(0.2, 0.4)) : meeting;
  const std::optional<CutTriangles> cut =
    cutCrossings(whole, worthCutting(parts, crossing), execution.phase(0.4, 0.7));
  if (!cut)
  {
    return std::nullopt;
  }
  return withoutShortEdges(withoutCovered(whole, parts, *cut, execution.phase(0.7, 1.0)),
    ShortestEdge * boundingBox(whole).diagonal().norm());
}

} // namespace evolving
