// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/CrossingPoints.h"

#include "Crossings/GridPoint.h"
#include "Crossings/PlaneCrossing.h"
#include "Mesh/Orientation.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace evolving
{

namespace
{

/// An edge and a triangle that it runs through.
using Piercing = std::pair<Index, Index>;

/// The ends of what two triangles have in common.
struct Ends
{
  Index vertex = NoIndex; ///< of both, which is then the first end
  std::vector<Piercing> piercings;
};

/// Looks at one pair of triangles.
class PairOfTriangles
{
public:
  PairOfTriangles(const SurfaceMesh& mesh, const TriangleEdges& edges, const IndexPair& pair)
    : Mesh(mesh)
    , Edges(edges)
    , Pair(pair)
  {
  }

  /// None where they do not cross by two edges, or by one from a common vertex.
  std::optional<Ends> ends() const
  {
    const std::vector<Index> shared = this->sharedVertices();
    if (shared.size() > 1)
    {
      return std::nullopt;
    }
    Ends found;
    found.vertex = shared.empty() ? NoIndex : shared.front();
    const bool isCut = this->addPiercings(this->Pair.first, this->Pair.second, found) &&
      this->addPiercings(this->Pair.second, this->Pair.first, found) &&
      found.piercings.size() + shared.size() == 2;
    return isCut ? std::make_optional(found) : std::nullopt;
  }

private:
  std::vector<Index> sharedVertices() const
  {
    std::vector<Index> shared;
    for (Index i = 0; i < 9; ++i)
    {
      const Index vertex = this->Mesh.faceVertex(this->Pair.first, i / 3);
      if (vertex == this->Mesh.faceVertex(this->Pair.second, i % 3))
      {
        shared.push_back(vertex);
      }
    }
    return shared;
  }

  /// Of the edges of a triangle, without those at a common vertex: they begin in the other's plane.
  /// @return false where something only touches
  bool addPiercings(Index edgesOf, Index triangle, Ends& found) const
  {
    const Vec3& a = this->Mesh.facePoint(triangle, 0);
    const Vec3& b = this->Mesh.facePoint(triangle, 1);
    const Vec3& c = this->Mesh.facePoint(triangle, 2);
    const auto isCommon = [&](Index k)
    { return this->Mesh.faceVertex(edgesOf, k) == found.vertex; };
    std::array<int, 3> sides{};
    for (Index k = 0; k < 3; ++k)
    {
      sides[at(k)] = isCommon(k) ? 0 : orientation(a, b, c, this->Mesh.facePoint(edgesOf, k));
      if (sides[at(k)] == 0 && !isCommon(k))
      {
        return false;
      }
    }
    for (Index k = 0; k < 3; ++k)
    {
      const Index next = (k + 1) % 3;
      if (sides[at(k)] * sides[at(next)] >= 0)
      {
        continue;
      }
      const Vec3& p = this->Mesh.facePoint(edgesOf, k);
      const Vec3& q = this->Mesh.facePoint(edgesOf, next);
      const std::array<int, 3> turns = { orientation(p, q, a, b), orientation(p, q, b, c),
        orientation(p, q, c, a) };
      const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
      if (*least == *most && *least != 0)
      {
        found.piercings.emplace_back(this->Edges.edgeOf(3 * edgesOf + k), triangle);
      }
      else if (*least >= 0 || *most <= 0)
      {
        return false;
      }
    }
    return true;
  }

  const SurfaceMesh& Mesh;
  const TriangleEdges& Edges;
  IndexPair Pair;
};

CrossingPoint placed(const SurfaceMesh& mesh, const TriangleEdges& edges, const Piercing& piercing)
{
  const auto [edge, triangle] = piercing;
  const Index corner = *edges.begin(edge);
  const Index face = corner / 3;
  const auto [low, high] =
    std::minmax({ mesh.faceVertex(face, corner % 3), mesh.faceVertex(face, (corner % 3 + 1) % 3) });
  const Vec3& p = mesh.points[at(low)];
  const Vec3& q = mesh.points[at(high)];
  const double part = placeAtPlane(mesh, triangle, p, q);
  const auto along = static_cast<std::int64_t>(std::llround(part * double(GridPoint::Unit)));
  return { edge, triangle, std::clamp<std::int64_t>(along, 1, GridPoint::Unit - 1),
    p + part * (q - p) };
}

} // namespace

CrossingPoints crossingPoints(const SurfaceMesh& mesh, const TriangleEdges& edges,
  const std::vector<IndexPair>& pairs, const Execution& execution)
{
  std::vector<std::optional<Ends>> ofPair(pairs.size());
  forEachIndex(execution, static_cast<std::int64_t>(pairs.size()),
    [&](Index i) { ofPair[at(i)] = PairOfTriangles(mesh, edges, pairs[at(i)]).ends(); });
  std::vector<Piercing> all;
  for (const auto& ends : ofPair)
  {
    if (ends)
    {
      all.insert(all.end(), ends->piercings.begin(), ends->piercings.end());
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const auto numberOf = [&](const Piercing& piercing)
  {
    return mesh.vertexCount() +
      static_cast<Index>(std::lower_bound(all.begin(), all.end(), piercing) - all.begin());
  };
  CrossingPoints crossings;
  crossings.points.resize(all.size());
  forEachIndex(execution, static_cast<std::int64_t>(all.size()),
    [&](Index i) { crossings.points[at(i)] = placed(mesh, edges, all[at(i)]); });
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    if (!ofPair[i])
    {
      crossings.uncut.push_back(pairs[i]);
      continue;
    }
    const Ends& ends = *ofPair[i];
    const Index first = ends.vertex != NoIndex ? ends.vertex : numberOf(ends.piercings.front());
    crossings.segments.push_back(
      { { pairs[i].first, pairs[i].second }, { first, numberOf(ends.piercings.back()) } });
  }
  return crossings;
}

} // namespace evolving
