// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/LabelIslands.h"

#include "Mesh/DisjointSets.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// Faces with one label that are connected over edges.
class Pieces
{
public:
  explicit Pieces(const EditableSurface& surface)
    : Surface(surface)
    , Sets(at(surface.faceSlots()))
    , Sizes(at(surface.faceSlots()), 0)
    , HasInside(at(surface.faceSlots()), 0)
  {
    for (Index e = 0; e < surface.edgeSlots(); ++e)
    {
      const Index beyond = this->beyond(e);
      if (beyond != NoIndex && surface.label(beyond) == surface.label(EditableSurface::faceOf(e)))
      {
        this->Sets.join(EditableSurface::faceOf(e), beyond);
      }
    }
    for (Index f = 0; f < surface.faceSlots(); ++f)
    {
      this->Sizes[at(this->of(f))] += surface.hasFace(f) ? 1 : 0;
    }
    this->findInsides();
  }

  Index of(Index face) { return this->Sets.find(face); }

  /// One of the faces of each piece that is an island.
  std::vector<Index> islands()
  {
    std::map<Index, Index> largest; ///< of each label
    for (Index f = 0; f < this->Surface.faceSlots(); ++f)
    {
      if (this->Surface.hasFace(f) && this->of(f) == f)
      {
        const auto found = largest.emplace(this->Surface.label(f), f).first;
        found->second = this->Sizes[at(f)] > this->Sizes[at(found->second)] ? f : found->second;
      }
    }
    std::vector<Index> islands;
    for (Index f = 0; f < this->Surface.faceSlots(); ++f)
    {
      if (this->Surface.hasFace(f) && this->of(f) == f && this->HasInside[at(f)] == 0 &&
        largest[this->Surface.label(f)] != f)
      {
        islands.push_back(f);
      }
    }
    return islands;
  }

  /// The face on the other side of an edge; NoIndex where there is none.
  Index beyond(Index e) const
  {
    const Index o = this->Surface.hasEdge(e) ? this->Surface.opposite(e) : NoIndex;
    return o == NoIndex ? NoIndex : EditableSurface::faceOf(o);
  }

private:
  void findInsides()
  {
    for (Index v = 0; v < this->Surface.vertexSlots(); ++v)
    {
      Index piece = NoIndex;
      bool isInside = this->Surface.hasVertex(v);
      if (isInside)
      {
        this->Surface.forEachOutgoing(v,
          [&](Index e)
          {
            const Index here = this->of(EditableSurface::faceOf(e));
            isInside = isInside && (piece == NoIndex || piece == here);
            piece = here;
          });
      }
      if (isInside && piece != NoIndex)
      {
        this->HasInside[at(piece)] = 1;
      }
    }
  }

  const EditableSurface& Surface;
  DisjointSets Sets;
  std::vector<Index> Sizes;
  std::vector<char> HasInside;
};

} // namespace

void joinIslands(EditableSurface& surface)
{
  Pieces pieces(surface);
  std::map<Index, std::map<Index, double>> borders; ///< of islands, by the label beyond
  for (const Index island : pieces.islands())
  {
    borders[island];
  }
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    const Index beyond = pieces.beyond(e);
    const auto found =
      beyond == NoIndex ? borders.end() : borders.find(pieces.of(EditableSurface::faceOf(e)));
    if (found != borders.end() && pieces.of(beyond) != found->first &&
      borders.count(pieces.of(beyond)) == 0)
    {
      found->second[surface.label(beyond)] += surface.length(e);
    }
  }
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    const auto found = surface.hasFace(f) ? borders.find(pieces.of(f)) : borders.end();
    if (found != borders.end() && !found->second.empty())
    {
      surface.setLabel(f,
        std::max_element(found->second.begin(), found->second.end(),
          [](const auto& a, const auto& b) { return a.second < b.second; })
          ->first);
    }
  }
}

} // namespace evolving
