// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/CoveredPieces.h"

#include "Distance/Signs/WindingNumber.h"
#include "Mesh/DisjointSets.h"
#include "Mesh/TriangleEdges.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>

namespace evolving
{

namespace
{

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

  /// A piece that was not cut where it should be is covered only if all of it is.
  bool isCovered(Index piece) const
  {
    const Triangle t = triangleOf(this->Cut.mesh, piece);
    const Vec3 middle = t.centroid();
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

/// Where pieces of a patch are as large and do not agree, a crossing was not cut.
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

} // namespace

std::vector<char> coveredPieces(const SurfaceMesh& whole, const SurfaceParts& parts,
  const CutTriangles& cut, const Execution& execution)
{
  const InsideOfParts inside(whole, parts, cut, execution.phase(0.0, 0.3));
  std::vector<char> isCovered(at(cut.mesh.faceCount()), 0);
  execution.phase(0.3, 1.0).forRangeReporting(cut.mesh.faceCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto piece = static_cast<Index>(begin); piece < static_cast<Index>(end); ++piece)
      {
        isCovered[at(piece)] = inside.isCovered(piece);
      }
    });
  letPatchesAgree(cut.mesh, isCovered);
  return isCovered;
}

} // namespace evolving
