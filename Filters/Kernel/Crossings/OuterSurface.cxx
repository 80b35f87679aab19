// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/OuterSurface.h"

#include "Crossings/CutTriangles.h"
#include "Crossings/GrownParts.h"
#include "Crossings/SeenSides.h"
#include "Crossings/SeparateSolids.h"
#include "Crossings/ShortEdges.h"
#include "Distance/Signs/OutwardOrientation.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/SurfaceParts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace evolving
{

namespace
{

/// Of the diagonal: a few times what parts are moved by. Contacts leave such edges, along which no
/// crease can be told.
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

/// With what is seen from behind turned.
SurfaceMesh withoutCovered(const SurfaceMesh& whole, const SurfaceParts& parts,
  const CutTriangles& cut, const Execution& execution)
{
  const std::vector<SeenSide> seen = seenSides(whole, parts, cut, execution);
  SurfaceMesh outer;
  outer.points = cut.mesh.points;
  for (Index piece = 0; piece < cut.mesh.faceCount(); ++piece)
  {
    const Index a = cut.mesh.faceVertex(piece, 0);
    const Index b = cut.mesh.faceVertex(piece, 1);
    const Index c = cut.mesh.faceVertex(piece, 2);
    switch (seen[at(piece)])
    {
      case SeenSide::None:
        break;
      case SeenSide::Front:
        outer.addFace({ a, b, c });
        break;
      case SeenSide::Back:
        outer.addFace({ a, c, b });
        break;
    }
  }
  return weldCoincidentPoints(outer);
}

} // namespace

std::optional<SurfaceMesh> outerSurface(
  const SurfaceMesh& surface, const Execution& execution, bool* isTangled)
{
  if (isTangled != nullptr)
  {
    *isTangled = false;
  }
  SurfaceMesh whole = separateSolids(surface);
  const std::vector<IndexPair> meeting =
    selfIntersections(triangleView(whole), execution.phase(0.0, 0.2));
  if (meeting.empty())
  {
    return std::nullopt;
  }
  orientOutwards(whole);
  const SurfaceParts parts = surfaceParts(whole);
  const std::vector<Vec3> grown = grownPoints(whole, parts, meeting);
  const bool haveGrown = grown != whole.points;
  whole.points = grown;
  const std::vector<IndexPair> crossing =
    haveGrown ? selfIntersections(triangleView(whole), execution.phase(0.2, 0.4)) : meeting;
  const std::optional<CutTriangles> cut =
    cutCrossings(whole, worthCutting(parts, crossing), execution.phase(0.4, 0.7), isTangled);
  if (!cut)
  {
    return std::nullopt;
  }
  return withoutShortEdges(withoutCovered(whole, parts, *cut, execution.phase(0.7, 1.0)),
    ShortestEdge * boundingBox(whole).diagonal().norm());
}

} // namespace evolving
