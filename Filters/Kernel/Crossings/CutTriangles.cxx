// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/CutTriangles.h"

#include "Crossings/CrossingLines.h"
#include "Crossings/GridTriangulation.h"
#include "Crossings/SegmentInsertion.h"
#include "Mesh/DisjointSets.h"

#include <array>
#include <map>
#include <utility>

namespace evolving
{

namespace
{

/// Triangles per chunk of a loop: a large one may have thousands of pieces.
constexpr std::int64_t CutGrain = 64;

/// What becomes of one triangle, by numbers of CrossingLines.
struct Pieces
{
  std::vector<std::array<Index, 3>> triangles;
  std::vector<IndexPair> same; ///< points that are one in the grid of the triangle
  std::vector<Index> uncut;    ///< segments that rounding makes cross others once more
};

/// Cuts one triangle.
class Cut
{
public:
  Cut(const SurfaceMesh& mesh, const CrossingLines& lines, Index triangle)
    : Lines(lines)
    , Triangle(triangle)
    , NumberOf({ mesh.faceVertex(triangle, 0), mesh.faceVertex(triangle, 1),
        mesh.faceVertex(triangle, 2) })
  {
  }

  Pieces run()
  {
    for (const Index number : this->Lines.pointsOnSides(this->Triangle))
    {
      this->insert(number);
    }
    const std::vector<Index>& segments = this->Lines.segmentsOf(this->Triangle);
    std::vector<std::vector<Index>> chains;
    for (const Index segment : segments)
    {
      chains.push_back(this->Lines.pointsAlong(segment));
      for (const Index number : chains.back())
      {
        this->insert(number);
      }
    }
    for (std::size_t s = 0; s < segments.size(); ++s)
    {
      if (!this->insertChain(chains[s]))
      {
        this->Result.uncut.push_back(segments[s]);
      }
    }
    for (Index c = 0; c < this->Cells.cellCount(); ++c)
    {
      const auto [i, j, k] = this->Cells.cell(c);
      this->Result.triangles.push_back(
        { this->NumberOf[at(i)], this->NumberOf[at(j)], this->NumberOf[at(k)] });
    }
    return std::move(this->Result);
  }

private:
  void insert(Index number)
  {
    const auto [entry, isNew] = this->VertexOf.try_emplace(number, NoIndex);
    if (!isNew)
    {
      return;
    }
    const Index vertex = this->Cells.insert(this->Lines.place(this->Triangle, number));
    entry->second = vertex;
    if (vertex < static_cast<Index>(this->NumberOf.size()))
    {
      this->Result.same.emplace_back(this->NumberOf[at(vertex)], number);
    }
    else
    {
      this->NumberOf.push_back(number);
    }
  }

  /// @return false where a part of it would cross another segment
  bool insertChain(const std::vector<Index>& chain)
  {
    bool isWhole = true;
    for (std::size_t i = 1; i < chain.size(); ++i)
    {
      const Index from = this->VertexOf[chain[i - 1]];
      isWhole = insertSegment(this->Cells, from, this->VertexOf[chain[i]]) && isWhole;
    }
    return isWhole;
  }

  const CrossingLines& Lines;
  Index Triangle;
  GridTriangulation Cells;
  std::vector<Index> NumberOf; ///< of each vertex
  std::map<Index, Index> VertexOf;
  Pieces Result;
};

std::vector<char> fullyCut(const CrossingLines& lines, const std::vector<Pieces>& pieces)
{
  std::vector<char> isFullyCut(pieces.size(), 1);
  for (const auto& [first, second] : lines.uncutPairs())
  {
    isFullyCut[at(first)] = 0;
    isFullyCut[at(second)] = 0;
  }
  for (const Pieces& p : pieces)
  {
    for (const Index segment : p.uncut)
    {
      for (const Index triangle : lines.trianglesOf(segment))
      {
        isFullyCut[at(triangle)] = 0;
      }
    }
  }
  return isFullyCut;
}

CutTriangles assembled(
  const SurfaceMesh& mesh, const CrossingLines& lines, const std::vector<Pieces>& pieces)
{
  DisjointSets same(at(lines.pointCount()));
  for (const Pieces& p : pieces)
  {
    for (const auto& [a, b] : p.same)
    {
      same.join(a, b);
    }
  }
  SurfaceMesh all;
  for (Index number = 0; number < lines.pointCount(); ++number)
  {
    all.addPoint(lines.point(number));
  }
  std::vector<Index> parents;
  for (Index t = 0; t < mesh.faceCount(); ++t)
  {
    for (const auto& [a, b, c] : pieces[at(t)].triangles)
    {
      all.addFace({ same.find(a), same.find(b), same.find(c) });
      parents.push_back(t);
    }
  }
  CutTriangles cut;
  std::vector<Index> kept;
  cut.mesh = weldCoincidentPoints(all, nullptr, &kept);
  for (const Index face : kept)
  {
    cut.oldFace.push_back(parents[at(face)]);
  }
  cut.isFullyCut = fullyCut(lines, pieces);
  return cut;
}

} // namespace

std::optional<CutTriangles> cutCrossings(const SurfaceMesh& mesh,
  const std::vector<IndexPair>& pairs, const Execution& execution, bool* areTooMany)
{
  const CrossingLines lines(mesh, pairs, execution.phase(0.0, 0.5));
  if (areTooMany != nullptr)
  {
    *areTooMany = lines.areTooMany();
  }
  if (lines.pointCount() == mesh.vertexCount() || lines.areTooMany())
  {
    return std::nullopt;
  }
  std::vector<Pieces> pieces(at(mesh.faceCount()));
  execution.phase(0.5, 1.0).forRangeReporting(mesh.faceCount(), CutGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto t = static_cast<Index>(begin); t < static_cast<Index>(end); ++t)
      {
        pieces[at(t)] = Cut(mesh, lines, t).run();
      }
    });
  return assembled(mesh, lines, pieces);
}

} // namespace evolving
