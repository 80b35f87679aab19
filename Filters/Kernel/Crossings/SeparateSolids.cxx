// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Crossings/SeparateSolids.h"

#include "Mesh/DisjointSets.h"
#include "Mesh/Orthogonal.h"
#include "Mesh/TriangleEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

namespace evolving
{

namespace
{

/// Radians: faces in one plane are on each other, whatever rounding says.
constexpr double SameAngle = 1e-6;

/// A face at an edge.
struct Leaf
{
  double angle = 0.0;       ///< about the edge, counter-clockwise as seen from its end, rounded
  bool runsUpwards = false; ///< then its solid is clockwise of it
  Index corner = NoIndex;

  /// Of two on each other the one with the solid clockwise of it comes first.
  auto order() const { return std::make_tuple(this->angle, !this->runsUpwards, this->corner); }
};

class Corners
{
public:
  explicit Corners(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , Edges(mesh)
    , Classes(at(mesh.cornerCount()))
  {
    for (Index edge = 0; edge < this->Edges.edgeCount(); ++edge)
    {
      this->joinAt(edge);
    }
  }

  SurfaceMesh separated()
  {
    SurfaceMesh apart;
    std::vector<Index> newVertex(at(this->Mesh.cornerCount()), NoIndex); // by first corner
    for (Index face = 0; face < this->Mesh.faceCount(); ++face)
    {
      std::array<Index, 3> vertices{};
      for (Index k = 0; k < 3; ++k)
      {
        Index& vertex = newVertex[at(this->Classes.find(3 * face + k))];
        vertex = vertex == NoIndex ? apart.addPoint(this->Mesh.facePoint(face, k)) : vertex;
        vertices[at(k)] = vertex;
      }
      apart.addFace({ vertices[0], vertices[1], vertices[2] });
    }
    return apart;
  }

private:
  /// Joins the corners of two faces at the ends of their common edge.
  void join(Index a, Index b)
  {
    const Index nextOfA = TriangleEdges::nextCorner(a);
    const Index nextOfB = TriangleEdges::nextCorner(b);
    const bool isSameWay =
      TriangleEdges::runsUpwards(this->Mesh, a) == TriangleEdges::runsUpwards(this->Mesh, b);
    this->Classes.join(a, isSameWay ? b : nextOfB);
    this->Classes.join(nextOfA, isSameWay ? nextOfB : b);
  }

  void joinAt(Index edge)
  {
    const Index* begin = this->Edges.begin(edge);
    const Index* end = this->Edges.end(edge);
    const auto upwards = std::count_if(
      begin, end, [this](Index corner) { return TriangleEdges::runsUpwards(this->Mesh, corner); });
    if (this->Edges.faceCount(edge) <= 2 || 2 * upwards != end - begin)
    {
      for (const Index* corner = begin + 1; corner < end; ++corner)
      {
        this->join(*begin, *corner);
      }
      return;
    }
    this->joinSolids(this->leavesAt(edge));
  }

  /// In the order of their angles.
  std::vector<Leaf> leavesAt(Index edge) const
  {
    const auto vertexOf = [this](Index corner) { return this->Mesh.cornerVertices[at(corner)]; };
    const Index first = *this->Edges.begin(edge);
    const auto [low, high] =
      std::minmax({ vertexOf(first), vertexOf(TriangleEdges::nextCorner(first)) });
    const Vec3& origin = this->Mesh.points[at(low)];
    const Vec3 along = (this->Mesh.points[at(high)] - origin).stableNormalized();
    const Vec3 x = orthogonalTo(along).stableNormalized();
    const Vec3 y = along.cross(x);
    std::vector<Leaf> leaves;
    for (const Index* corner = this->Edges.begin(edge); corner != this->Edges.end(edge); ++corner)
    {
      const Index opposite = TriangleEdges::nextCorner(TriangleEdges::nextCorner(*corner));
      const Vec3 across = this->Mesh.points[at(vertexOf(opposite))] - origin;
      const double angle = std::atan2(across.dot(y), across.dot(x));
      leaves.push_back({ std::round(angle / SameAngle),
        TriangleEdges::runsUpwards(this->Mesh, *corner), *corner });
    }
    std::sort(leaves.begin(), leaves.end(),
      [](const Leaf& a, const Leaf& b) { return a.order() < b.order(); });
    return leaves;
  }

  /// Counter-clockwise of a face that runs downwards is its solid, up to the next that runs
  /// upwards; where solids lie in each other these are nested as brackets are.
  void joinSolids(const std::vector<Leaf>& leaves)
  {
    std::vector<Index> open;
    std::vector<Index> unmatched; // their solids began before the angle -180 degrees
    for (const Leaf& leaf : leaves)
    {
      if (!leaf.runsUpwards)
      {
        open.push_back(leaf.corner);
      }
      else if (open.empty())
      {
        unmatched.push_back(leaf.corner);
      }
      else
      {
        this->join(open.back(), leaf.corner);
        open.pop_back();
      }
    }
    for (const Index corner : unmatched) // as many as are open
    {
      this->join(open.back(), corner);
      open.pop_back();
    }
  }

  const SurfaceMesh& Mesh;
  TriangleEdges Edges;
  DisjointSets Classes; ///< of corners that are one vertex
};

} // namespace

SurfaceMesh separateSolids(const SurfaceMesh& surface)
{
  return Corners(surface).separated();
}

} // namespace evolving
