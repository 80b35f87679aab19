// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/HoleFilling.h"

#include "Mesh/BoxPairs.h"
#include "Mesh/PolygonTriangulation.h"
#include "Mesh/SelfIntersections.h"
#include "StartSurface/LeastAreaCap.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

namespace evolving
{

namespace
{

using Cap = std::vector<std::array<Index, 3>>;

/// Of a loop, in vertices: n^3 / 6 evaluations (LeastAreaCap.h) are a twentieth of a second then.
constexpr std::size_t LongestForLeastArea = 300;
/// Of a cap: each forbids the diagonals that made the last one cross something.
constexpr int Choices = 5;

/// Edges by the numbers of their ends, in any order.
class EdgeSet
{
public:
  void add(Index a, Index b) { this->Edges.insert(std::minmax(a, b)); }
  void addTriangle(Index a, Index b, Index c)
  {
    this->add(a, b);
    this->add(b, c);
    this->add(c, a);
  }
  bool contains(Index a, Index b) const { return this->Edges.count(std::minmax(a, b)) > 0; }

private:
  std::set<std::pair<Index, Index>> Edges;
};

/// The edges with both ends at holes, which no cap may use again.
EdgeSet edgesAtHoles(const SurfaceMesh& mesh, const std::vector<BoundaryLoop>& holes)
{
  std::vector<char> isAtHole(mesh.points.size(), 0);
  for (const BoundaryLoop& hole : holes)
  {
    for (const Index vertex : hole.vertices)
    {
      isAtHole[at(vertex)] = 1;
    }
  }
  EdgeSet edges;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    for (Index k = 0; k < mesh.faceSize(face); ++k)
    {
      const Index a = mesh.faceVertex(face, k);
      const Index b = mesh.faceVertex(face, (k + 1) % mesh.faceSize(face));
      if (isAtHole[at(a)] && isAtHole[at(b)])
      {
        edges.add(a, b);
      }
    }
  }
  return edges;
}

/// A cap's triangles behind a mesh, against the loop, since most faces run along it.
void appendCap(SurfaceMesh& mesh, const std::vector<Index>& loop, const Cap& cap)
{
  for (const std::array<Index, 3>& t : cap)
  {
    mesh.addFace({ loop[at(t[2])], loop[at(t[1])], loop[at(t[0])] });
  }
}

/// For each hole the faces whose boxes touch its own, within which its cap stays.
std::vector<std::vector<Index>> facesAtHoles(
  const SurfaceMesh& mesh, const std::vector<BoundaryLoop>& holes, const Execution& execution)
{
  std::vector<Box> around(holes.size());
  for (std::size_t hole = 0; hole < holes.size(); ++hole)
  {
    for (const Index vertex : holes[hole].vertices)
    {
      around[hole].extend(mesh.points[at(vertex)]);
    }
  }
  std::vector<Box> boxes(at(holes.empty() ? 0 : mesh.faceCount()));
  for (Index face = 0; face < static_cast<Index>(boxes.size()); ++face)
  {
    for (Index k = 0; k < 3; ++k)
    {
      boxes[at(face)].extend(mesh.facePoint(face, k));
    }
  }
  return boxesOverlapping(around, boxes, execution);
}

/// A hole, and the faces that its cap might cross.
class Surroundings
{
public:
  Surroundings(const SurfaceMesh& mesh, const BoundaryLoop& hole, const std::vector<Index>& faces)
    : Source(mesh)
  {
    for (const Index vertex : hole.vertices)
    {
      this->Loop.push_back(this->numberOf(vertex));
    }
    for (const Index face : faces)
    {
      this->Faces.addFace({ this->numberOf(mesh.faceVertex(face, 0)),
        this->numberOf(mesh.faceVertex(face, 1)), this->numberOf(mesh.faceVertex(face, 2)) });
    }
  }

  /// The triangles of a cap that cross each other or a face.
  std::set<std::size_t> crossingTriangles(const Cap& cap) const
  {
    SurfaceMesh together = this->Faces;
    appendCap(together, this->Loop, cap);
    std::set<std::size_t> crossing;
    for (const auto& [first, second] : selfIntersections(together))
    {
      for (const Index face : { first, second })
      {
        if (face >= this->Faces.faceCount())
        {
          crossing.insert(at(face - this->Faces.faceCount()));
        }
      }
    }
    return crossing;
  }

private:
  Index numberOf(Index vertex)
  {
    const auto [entry, isNew] = this->Numbers.emplace(vertex, this->Faces.vertexCount());
    return isNew ? this->Faces.addPoint(this->Source.points[at(vertex)]) : entry->second;
  }

  const SurfaceMesh& Source;
  SurfaceMesh Faces;
  std::vector<Index> Loop; ///< the hole's vertices by their numbers here
  std::unordered_map<Index, Index> Numbers;
};

/// The choice with the fewest crossing triangles, which is none nearly always.
Cap leastAreaCapApart(const Surroundings& surroundings, const BoundaryLoop& hole,
  const std::vector<Vec3>& corners, const EdgeSet& taken)
{
  EdgeSet avoided;
  const auto isAllowed = [&](Index a, Index b) {
    return !taken.contains(hole.vertices[at(a)], hole.vertices[at(b)]) && !avoided.contains(a, b);
  };
  Cap best;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (int choice = 0; choice < Choices && fewest > 0; ++choice)
  {
    Cap cap = leastAreaCap(corners, isAllowed);
    if (cap.empty())
    {
      break;
    }
    const std::set<std::size_t> crossing = surroundings.crossingTriangles(cap);
    for (const std::size_t t : crossing)
    {
      avoided.addTriangle(cap[t][0], cap[t][1], cap[t][2]);
    }
    if (crossing.size() < fewest)
    {
      fewest = crossing.size();
      best = std::move(cap);
    }
  }
  return best;
}

Cap capOf(const SurfaceMesh& mesh, const BoundaryLoop& hole, const std::vector<Index>& faces,
  const EdgeSet& taken)
{
  std::vector<Vec3> corners;
  for (const Index vertex : hole.vertices)
  {
    corners.push_back(mesh.points[at(vertex)] - mesh.points[at(hole.vertices[0])]);
  }
  return corners.size() > LongestForLeastArea
    ? triangulatePolygon(corners)
    : leastAreaCapApart(Surroundings(mesh, hole, faces), hole, corners, taken);
}

} // namespace

SurfaceMesh fillHoles(
  const SurfaceMesh& mesh, const std::vector<BoundaryLoop>& holes, const Execution& execution)
{
  SurfaceMesh filled = mesh;
  EdgeSet taken = edgesAtHoles(mesh, holes);
  const std::vector<std::vector<Index>> faces =
    facesAtHoles(mesh, holes, execution.phase(0.0, 0.5));
  for (std::size_t i = 0; i < holes.size(); ++i)
  {
    const BoundaryLoop& hole = holes[i];
    execution.report(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(holes.size()));
    const Cap cap = capOf(mesh, hole, faces[i], taken);
    appendCap(filled, hole.vertices, cap);
    for (const std::array<Index, 3>& t : cap)
    {
      taken.addTriangle(hole.vertices[at(t[0])], hole.vertices[at(t[1])], hole.vertices[at(t[2])]);
    }
  }
  return filled;
}

} // namespace evolving
