// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/SolidSheets.h"

#include "Crossings/SeparateSolids.h"
#include "Distance/Signs/OutwardOrientation.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/SurfaceParts.h"
#include "Mesh/TriangleEdges.h"
#include "Mesh/VertexNormals.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <vector>

namespace evolving
{

namespace
{

/// Of the area: the rest is where sides are hard to tell, at rims and folds.
constexpr double MostlySheet = 0.8;
/// A side is moved by this many halves at most where faces meet at an angle.
constexpr double LongestMitre = 2.0;

class Solids
{
public:
  Solids(const SurfaceMesh& surface, double half)
    : Surface(surface)
    , Half(half)
    , Edges(surface)
    , Parts(surfaceParts(surface))
    , CanBeSolid(this->Parts.list.size(), 1)
    , Moves(this->mitredNormals())
  {
    this->leaveClosedAndTangled();
  }

  void leavePartlySheet(const std::function<bool(const Vec3&)>& isSheet)
  {
    std::vector<double> sheetArea(this->Parts.list.size(), 0.0);
    for (Index f = 0; f < this->Surface.faceCount(); ++f)
    {
      if (this->isSolid(f) && isSheet(triangleOf(this->Surface, f).centroid()))
      {
        sheetArea[at(this->partOf(f))] += faceVectorArea(this->Surface, f).norm();
      }
    }
    for (std::size_t part = 0; part < sheetArea.size(); ++part)
    {
      if (sheetArea[part] < MostlySheet * this->Parts.list[part].area)
      {
        this->CanBeSolid[part] = 0;
      }
    }
  }

  void leaveSelfCrossing(const Execution& execution)
  {
    std::vector<Index> parts;
    const SurfaceMesh solids = this->surface(parts);
    for (const auto& [a, b] : selfIntersections(triangleView(solids), execution))
    {
      if (parts[at(a)] == parts[at(b)] && this->CanBeSolid[at(parts[at(a)])] != 0)
      {
        this->CanBeSolid[at(parts[at(a)])] = 0;
      }
    }
  }

  bool areNone() const
  {
    return std::none_of(
      this->CanBeSolid.begin(), this->CanBeSolid.end(), [](char can) { return can != 0; });
  }

  /// @param[out] parts of each face
  SurfaceMesh surface(std::vector<Index>& parts) const
  {
    const Index count = this->Surface.vertexCount();
    SurfaceMesh mesh;
    mesh.points = this->Surface.points; // of what stays, then of the upper and the lower sides
    for (const double side : { this->Half, -this->Half })
    {
      for (Index v = 0; v < count; ++v)
      {
        mesh.addPoint(this->Surface.points[at(v)] + side * this->Moves[at(v)]);
      }
    }
    const auto add = [&](Index part, Index a, Index b, Index c)
    {
      mesh.addFace({ a, b, c });
      parts.push_back(part);
    };
    for (Index f = 0; f < this->Surface.faceCount(); ++f)
    {
      const Index a = this->Surface.faceVertex(f, 0);
      const Index b = this->Surface.faceVertex(f, 1);
      const Index c = this->Surface.faceVertex(f, 2);
      if (!this->isSolid(f))
      {
        add(this->partOf(f), a, b, c);
        continue;
      }
      add(this->partOf(f), count + a, count + b, count + c);
      add(this->partOf(f), 2 * count + a, 2 * count + c, 2 * count + b);
      for (Index k = 0; k < 3; ++k)
      {
        if (this->Edges.faceCount(this->Edges.edgeOf(3 * f + k)) == 1)
        {
          const Index from = this->Surface.faceVertex(f, k);
          const Index to = this->Surface.faceVertex(f, (k + 1) % 3);
          add(this->partOf(f), count + to, count + from, 2 * count + from);
          add(this->partOf(f), count + to, 2 * count + from, 2 * count + to);
        }
      }
    }
    return mesh;
  }

private:
  Index partOf(Index face) const { return this->Parts.ofFace[at(face)]; }
  bool isSolid(Index face) const { return this->CanBeSolid[at(this->partOf(face))] != 0; }

  /// So long that the faces at a vertex move by one.
  std::vector<Vec3> mitredNormals() const
  {
    std::vector<Vec3> normals = angleWeightedNormals(this->Surface);
    std::vector<double> least(normals.size(), 1.0);
    for (Index f = 0; f < this->Surface.faceCount(); ++f)
    {
      const Vec3 normal = faceVectorArea(this->Surface, f).stableNormalized();
      for (Index k = 0; k < 3; ++k)
      {
        const auto v = at(this->Surface.faceVertex(f, k));
        least[v] = std::min(least[v], normal.dot(normals[v]));
      }
    }
    for (std::size_t v = 0; v < normals.size(); ++v)
    {
      normals[v] /= std::max(least[v], 1.0 / LongestMitre);
    }
    return normals;
  }

  void leaveClosedAndTangled()
  {
    for (std::size_t part = 0; part < this->Parts.list.size(); ++part)
    {
      this->CanBeSolid[part] = !this->Parts.list[part].isClosed;
    }
    for (Index edge = 0; edge < this->Edges.edgeCount(); ++edge)
    {
      const Index* corners = this->Edges.begin(edge);
      const Index faces = this->Edges.faceCount(edge);
      const bool isTurned = faces == 2 &&
        TriangleEdges::runsUpwards(this->Surface, corners[0]) ==
          TriangleEdges::runsUpwards(this->Surface, corners[1]);
      if (faces > 2 || isTurned)
      {
        this->CanBeSolid[at(this->partOf(corners[0] / 3))] = 0;
      }
    }
  }

  const SurfaceMesh& Surface;
  double Half;
  TriangleEdges Edges;
  SurfaceParts Parts;
  std::vector<char> CanBeSolid; ///< of each part
  std::vector<Vec3> Moves;      ///< of each vertex, to its upper side
};

} // namespace

std::optional<SurfaceMesh> solidSheets(const SurfaceMesh& surface,
  const std::function<bool(const Vec3&)>& isSheet, double half, const Execution& execution)
{
  SurfaceMesh apart = separateSolids(surface);
  orientOutwards(apart);
  Solids solids(apart, half);
  solids.leavePartlySheet(isSheet);
  if (!solids.areNone())
  {
    solids.leaveSelfCrossing(execution);
  }
  if (solids.areNone())
  {
    return std::nullopt;
  }
  std::vector<Index> parts;
  return weldCoincidentPoints(solids.surface(parts));
}

} // namespace evolving
