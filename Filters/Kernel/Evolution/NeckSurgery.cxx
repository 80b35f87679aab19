// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/NeckSurgery.h"

#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceParts.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

namespace evolving
{

namespace
{

/// Of the edge length: remeshing leaves none as short but where the topology forbids to collapse
/// it.
constexpr double ShortPart = 0.5;
/// Of the edge length squared: components with less, a dozen elements, are rests of a thread.
constexpr double RestArea = 5.0;

/// Three vertices in the order of a closed line; the surface has a side on its left and one right.
using Neck = std::array<Index, 3>;

class Cutter
{
public:
  Cutter(const SurfaceMesh& surface, double edgeLength)
    : Surface(surface)
    , Topology(surface)
    , Longest(ShortPart * edgeLength)
    , IsTaken(surface.points.size(), 0)
    , Corners(at(this->Topology.cornerCount()))
  {
    for (Index c = 0; c < this->Topology.cornerCount(); ++c)
    {
      this->Corners[at(c)] = this->Topology.vertexOf(c);
    }
  }

  /// Nothing when there is no neck.
  std::optional<SurfaceMesh> cut()
  {
    for (Index v = 0; v < this->Surface.vertexCount(); ++v)
    {
      if (const auto neck = this->neckAt(v))
      {
        this->cutAlong(*neck);
      }
    }
    return this->Caps.empty() ? std::nullopt : std::make_optional(this->result());
  }

private:
  bool isShort(Index a, Index b) const
  {
    return (this->Surface.points[at(a)] - this->Surface.points[at(b)]).norm() < this->Longest;
  }

  /// Necks share no vertex, so that each vertex is split once.
  bool isFree(Index v) const { return !this->IsTaken[at(v)] && !this->Topology.isBoundary(v); }

  /// The place of a neighbour around a vertex; -1 when it is none.
  Index placeOf(Index vertex, Index neighbour) const
  {
    const MeshTopology::Run ring = this->Topology.ringVertices(vertex);
    const auto* found = std::find(ring.begin(), ring.end(), neighbour);
    return found == ring.end() ? -1 : static_cast<Index>(found - ring.begin());
  }

  /// Neighbours that follow each other around a vertex have a face with it.
  bool isFace(Index a, Index b, Index c) const
  {
    const Index ring = this->Topology.ringVertices(a).size();
    const Index step = (this->placeOf(a, c) - this->placeOf(a, b) + ring) % ring;
    return step == 1 || step == ring - 1;
  }

  std::optional<Neck> neckAt(Index a) const
  {
    if (!this->Topology.isUsed(a) || !this->isFree(a))
    {
      return std::nullopt;
    }
    for (const Index b : this->Topology.ringVertices(a))
    {
      for (const Index c : this->Topology.ringVertices(a))
      {
        const bool isLoop = b < c && this->isFree(b) && this->isFree(c) && this->isShort(a, b) &&
          this->isShort(a, c) && this->isShort(b, c) && this->placeOf(b, c) >= 0;
        if (isLoop && !this->isFace(a, b, c))
        {
          return Neck{ a, b, c };
        }
      }
    }
    return std::nullopt;
  }

  /// The faces on the left get vertices of their own.
  void cutAlong(const Neck& neck)
  {
    Neck left{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index v = neck[k];
      left[k] = this->Surface.vertexCount() + static_cast<Index>(this->NewPoints.size());
      this->NewPoints.push_back(this->Surface.points[at(v)]);
      this->IsTaken[at(v)] = 1;
      const MeshTopology::Run corners = this->Topology.ringCorners(v);
      const Index end = this->placeOf(v, neck[(k + 2) % 3]);
      for (Index i = this->placeOf(v, neck[(k + 1) % 3]); i != end; i = (i + 1) % corners.size())
      {
        this->Corners[at(corners[i])] = left[k];
      }
    }
    this->Caps.push_back({ left[0], left[2], left[1] });
    this->Caps.push_back(neck);
  }

  SurfaceMesh result() const
  {
    SurfaceMesh cut;
    cut.points = this->Surface.points;
    cut.points.insert(cut.points.end(), this->NewPoints.begin(), this->NewPoints.end());
    for (std::size_t c = 0; c < this->Corners.size(); c += 3)
    {
      cut.addFace({ this->Corners[c], this->Corners[c + 1], this->Corners[c + 2] });
    }
    for (const Neck& cap : this->Caps)
    {
      cut.addFace({ cap[0], cap[1], cap[2] });
    }
    return cut;
  }

  const SurfaceMesh& Surface;
  MeshTopology Topology;
  double Longest;
  std::vector<char> IsTaken;
  std::vector<Index> Corners; ///< the vertex of each
  std::vector<Vec3> NewPoints;
  std::vector<Neck> Caps;
};

SurfaceMesh withoutRests(const SurfaceMesh& surface, double smallestArea)
{
  const SurfaceParts parts = surfaceParts(surface);
  SurfaceMesh rest;
  rest.points = surface.points;
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    if (parts.list[at(parts.ofFace[at(face)])].area >= smallestArea)
    {
      rest.addFace(
        { surface.faceVertex(face, 0), surface.faceVertex(face, 1), surface.faceVertex(face, 2) });
    }
  }
  return rest.faceCount() > 0 ? rest : surface;
}

} // namespace

SurfaceMesh withNecksCut(const SurfaceMesh& surface, double edgeLength)
{
  const std::optional<SurfaceMesh> cut = Cutter(surface, edgeLength).cut();
  return cut ? withoutRests(*cut, RestArea * edgeLength * edgeLength) : surface;
}

} // namespace evolving
