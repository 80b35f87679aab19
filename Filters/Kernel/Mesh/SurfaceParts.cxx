// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/SurfaceParts.h"

#include "Mesh/DisjointSets.h"
#include "Mesh/TriangleEdges.h"

#include <cmath>

namespace evolving
{

namespace
{

/// The faces along an edge that count.
std::vector<Index> facesAlong(const SurfaceMesh& surface, const TriangleEdges& edges, Index edge)
{
  std::vector<Index> faces;
  for (const Index* corner = edges.begin(edge); corner != edges.end(edge); ++corner)
  {
    if (!usesAPointTwice(surface, *corner / 3))
    {
      faces.push_back(*corner / 3);
    }
  }
  return faces;
}

/// The faces that edges connect, as the number of their part; marks a face at each edge that is
/// not inside a manifold.
std::vector<Index> connect(const SurfaceMesh& surface, std::vector<char>& isAtOpenEdge)
{
  const TriangleEdges edges(surface);
  DisjointSets sets(at(surface.faceCount()));
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    const std::vector<Index> faces = facesAlong(surface, edges, edge);
    for (std::size_t i = 1; i < faces.size(); ++i)
    {
      sets.join(faces.front(), faces[i]);
    }
    if (!faces.empty() && faces.size() != 2)
    {
      isAtOpenEdge[at(faces.front())] = 1;
    }
  }
  std::vector<Index> ofFace(at(surface.faceCount()));
  Index count = 0;
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const Index first = sets.find(face); // the smallest: it has its number already
    ofFace[at(face)] = first == face ? count++ : ofFace[at(first)];
  }
  return ofFace;
}

} // namespace

double SurfacePart::meanThickness() const
{
  return this->area > 0.0 ? std::abs(this->sixVolumes) / (3.0 * this->area) : 0.0;
}

bool usesAPointTwice(const SurfaceMesh& surface, Index face)
{
  const Index a = surface.faceVertex(face, 0);
  const Index b = surface.faceVertex(face, 1);
  const Index c = surface.faceVertex(face, 2);
  return a == b || b == c || c == a;
}

SurfaceParts surfaceParts(const SurfaceMesh& surface)
{
  SurfaceParts parts;
  std::vector<char> isAtOpenEdge(at(surface.faceCount()), 0);
  parts.ofFace = connect(surface, isAtOpenEdge);
  std::vector<Vec3> origins; // a point of each part
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const auto part = at(parts.ofFace[at(face)]);
    if (part == parts.list.size())
    {
      parts.list.emplace_back();
      origins.push_back(surface.facePoint(face, 0));
    }
    SurfacePart& measured = parts.list[part];
    const Vec3 doubleArea = 2.0 * faceVectorArea(surface, face);
    measured.isClosed = measured.isClosed && isAtOpenEdge[at(face)] == 0;
    measured.area += 0.5 * doubleArea.norm();
    measured.sixVolumes += doubleArea.dot(surface.facePoint(face, 0) - origins[part]);
  }
  return parts;
}

} // namespace evolving
