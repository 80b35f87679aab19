// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/SeenSides.h"

#include "Crossings/GridPoint.h"
#include "Distance/Signs/WindingNumber.h"
#include "Mesh/DisjointSets.h"
#include "Mesh/TriangleEdges.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace evolving
{

namespace
{

double longestEdge(const Triangle& t)
{
  return std::max({ (t.corners[1] - t.corners[0]).norm(), (t.corners[2] - t.corners[1]).norm(),
    (t.corners[0] - t.corners[2]).norm() });
}

double height(const Triangle& t)
{
  const double longest = longestEdge(t);
  return longest > 0.0 ? t.doubleAreaNormal().norm() / longest : 0.0;
}

/// Which pieces lie inside closed parts.
class InsideOfParts
{
public:
  /// @param whole before it was cut. All must outlive this
  InsideOfParts(const SurfaceMesh& whole, const SurfaceParts& parts, const CutTriangles& cut,
    const Execution& execution)
    : Whole(whole)
    , Parts(parts)
    , Cut(cut)
    , Winding(trianglesOfClosedParts(whole, parts), execution)
  {
  }

  /// Of a piece that is as a whole on one side of all others.
  SeenSide sideOf(Index piece) const
  {
    return this->sideFor(
      piece, this->windingAt(piece, triangleOf(this->Cut.mesh, piece).centroid()));
  }

  /// Of any piece; none where it is in doubt.
  std::optional<SeenSide> clearSideOf(Index piece) const
  {
    const Triangle t = triangleOf(this->Cut.mesh, piece);
    const Triangle old = triangleOf(this->Whole, this->Cut.oldFace[at(piece)]);
    if (height(t) < SliverUnits / double(GridPoint::Unit) * longestEdge(old))
    {
      return std::nullopt;
    }
    const Vec3 middle = t.centroid();
    std::array<Vec3, 4> points = { middle, t.corners[0], t.corners[1], t.corners[2] };
    SeenSide seen = SeenSide::None;
    for (const Vec3& point : points)
    {
      const double winding = this->windingAt(piece, middle + TowardsCorner * (point - middle));
      if (this->isInDoubt(piece, winding))
      {
        return std::nullopt;
      }
      seen = seen == SeenSide::None ? this->sideFor(piece, winding) : seen;
    }
    return seen;
  }

private:
  static constexpr double TowardsCorner = 0.9;
  static constexpr double Doubt = 5.0 * WindingNumber::Tolerance;
  /// Pieces that are no higher have their shape from rounding.
  static constexpr double SliverUnits = 8.0;

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

  bool isOfClosedPart(Index piece) const
  {
    const Index triangle = this->Cut.oldFace[at(piece)];
    return this->Parts.list[at(this->Parts.ofFace[at(triangle)])].isClosed;
  }

  /// Of all triangles but the piece's own: of a closed part, the mean of its two sides.
  double windingAt(Index piece, const Vec3& point) const
  {
    const double all = this->Winding.at(point);
    return this->isOfClosedPart(piece)
      ? all - windingNumber(triangleOf(this->Whole, this->Cut.oldFace[at(piece)]), point)
      : all;
  }

  SeenSide sideFor(Index piece, double winding) const
  {
    if (std::abs(winding) > (this->isOfClosedPart(piece) ? 1.0 : 0.5))
    {
      return SeenSide::None;
    }
    return this->isOfClosedPart(piece) && winding < 0.0 ? SeenSide::Back : SeenSide::Front;
  }

  bool isInDoubt(Index piece, double winding) const
  {
    const double whole = this->isOfClosedPart(piece) ? winding - 0.5 : winding;
    return std::abs(whole - std::round(whole)) > Doubt;
  }

  const SurfaceMesh& Whole;
  const SurfaceParts& Parts;
  const CutTriangles& Cut;
  WindingNumber Winding;
};

/// Pieces that are connected across edges of two, where both `mayJoin`.
template <class MayJoin>
std::vector<Index> connectedPieces(
  const SurfaceMesh& pieces, const TriangleEdges& edges, const MayJoin& mayJoin)
{
  DisjointSets sets(at(pieces.faceCount()));
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    const Index first = edges.begin(edge)[0] / 3;
    const Index last = edges.end(edge)[-1] / 3;
    if (edges.faceCount(edge) == 2 && mayJoin(first) && mayJoin(last))
    {
      sets.join(first, last);
    }
  }
  std::vector<Index> setOf(at(pieces.faceCount()));
  for (Index piece = 0; piece < pieces.faceCount(); ++piece)
  {
    setOf[at(piece)] = sets.find(piece);
  }
  return setOf;
}

/// Of each set, by its first member, the piece of the largest height.
std::vector<Index> highestPieces(const SurfaceMesh& pieces, const std::vector<Index>& setOf)
{
  std::vector<Index> highest(setOf.size(), NoIndex);
  std::vector<double> heights(setOf.size(), -1.0);
  for (Index piece = 0; piece < pieces.faceCount(); ++piece)
  {
    const double h = height(triangleOf(pieces, piece));
    const std::size_t set = at(setOf[at(piece)]);
    if (h > heights[set])
    {
      heights[set] = h;
      highest[set] = piece;
    }
  }
  return highest;
}

/// What is in doubt is as most of its patch is, by area.
void followPatches(const SurfaceMesh& pieces, const TriangleEdges& edges,
  std::vector<std::optional<SeenSide>>& sides)
{
  const std::vector<Index> patchOf = connectedPieces(pieces, edges, [](Index) { return true; });
  std::map<Index, std::array<double, 3>> areas; // by side
  for (Index piece = 0; piece < pieces.faceCount(); ++piece)
  {
    if (sides[at(piece)])
    {
      areas[patchOf[at(piece)]][static_cast<std::size_t>(*sides[at(piece)])] +=
        faceVectorArea(pieces, piece).norm();
    }
  }
  for (Index piece = 0; piece < pieces.faceCount(); ++piece)
  {
    if (!sides[at(piece)])
    {
      const auto area = areas.find(patchOf[at(piece)]);
      sides[at(piece)] = area == areas.end()
        ? SeenSide::Front
        : static_cast<SeenSide>(
            std::max_element(area->second.begin(), area->second.end()) - area->second.begin());
    }
  }
}

} // namespace

std::vector<SeenSide> seenSides(const SurfaceMesh& whole, const SurfaceParts& parts,
  const CutTriangles& cut, const Execution& execution)
{
  const InsideOfParts inside(whole, parts, cut, execution.phase(0.0, 0.3));
  const auto isFullyCut = [&cut](Index piece)
  { return cut.isFullyCut[at(cut.oldFace[at(piece)])] != 0; };
  const TriangleEdges edges(cut.mesh);
  const std::vector<Index> regionOf = connectedPieces(cut.mesh, edges, isFullyCut);
  const std::vector<Index> asked = highestPieces(cut.mesh, regionOf);
  std::vector<std::optional<SeenSide>> sides(asked.size());
  execution.phase(0.3, 1.0).forRangeReporting(cut.mesh.faceCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto region = static_cast<Index>(begin); region < static_cast<Index>(end); ++region)
      {
        const Index piece = asked[at(region)];
        if (piece != NoIndex)
        {
          sides[at(region)] = isFullyCut(piece) ? inside.sideOf(piece) : inside.clearSideOf(piece);
        }
      }
    });
  for (std::size_t piece = 0; piece < sides.size(); ++piece)
  {
    sides[piece] = sides[at(regionOf[piece])];
  }
  followPatches(cut.mesh, edges, sides);
  std::vector<SeenSide> seen(sides.size());
  std::transform(sides.begin(), sides.end(), seen.begin(), [](const auto& side) { return *side; });
  return seen;
}

} // namespace evolving
