// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/ClosedParts.h"

#include "Mesh/DisjointSets.h"
#include "Mesh/TriangleEdges.h"

#include <cmath>

namespace evolving
{

namespace
{

struct Part
{
  bool isOpen = false;
  double area = 0.0;
  double sixVolumes = 0.0; ///< signed; less than it is where faces are turned against each other

  void add(const SurfaceMesh& surface, Index face, const Vec3& origin)
  {
    const Vec3 doubleArea = 2.0 * faceVectorArea(surface, face);
    this->area += 0.5 * doubleArea.norm();
    this->sixVolumes += doubleArea.dot(surface.facePoint(face, 0) - origin);
  }

  double meanThickness() const
  {
    return this->area > 0.0 ? std::abs(this->sixVolumes) / (3.0 * this->area) : 0.0;
  }
};

bool usesAPointTwice(const SurfaceMesh& surface, Index face)
{
  const Index a = surface.faceVertex(face, 0);
  const Index b = surface.faceVertex(face, 1);
  const Index c = surface.faceVertex(face, 2);
  return a == b || b == c || c == a;
}

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

} // namespace

std::vector<char> facesOfClosedParts(const SurfaceMesh& surface, double thickness)
{
  const TriangleEdges edges(surface);
  DisjointSets parts(at(surface.faceCount()));
  std::vector<Index> open; // a face at each edge that is not inside a manifold
  for (Index edge = 0; edge < edges.edgeCount(); ++edge)
  {
    const std::vector<Index> faces = facesAlong(surface, edges, edge);
    for (std::size_t i = 1; i < faces.size(); ++i)
    {
      parts.join(faces.front(), faces[i]);
    }
    if (!faces.empty() && faces.size() != 2)
    {
      open.push_back(faces.front());
    }
  }
  std::vector<Part> measured(at(surface.faceCount())); // by their smallest face
  for (const Index face : open)
  {
    measured[at(parts.find(face))].isOpen = true;
  }
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const Index first = parts.find(face);
    measured[at(first)].add(surface, face, surface.facePoint(first, 0));
  }
  std::vector<char> isClosed(at(surface.faceCount()), 0);
  for (Index face = 0; face < surface.faceCount(); ++face)
  {
    const Part& part = measured[at(parts.find(face))];
    isClosed[at(face)] =
      !part.isOpen && part.meanThickness() > thickness && !usesAPointTwice(surface, face);
  }
  return isClosed;
}

} // namespace evolving
