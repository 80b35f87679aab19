// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/ConnectedComponents.h"

#include "Mesh/DisjointSets.h"

namespace evolving
{

namespace
{

DisjointSets joinedByFaces(const SurfaceMesh& mesh)
{
  DisjointSets sets(mesh.points.size());
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    for (Index k = 1; k < mesh.faceSize(face); ++k)
    {
      sets.join(mesh.faceVertex(face, k - 1), mesh.faceVertex(face, k));
    }
  }
  return sets;
}

} // namespace

ConnectedComponents connectedComponents(const SurfaceMesh& mesh)
{
  DisjointSets sets = joinedByFaces(mesh);
  std::vector<char> used(mesh.points.size(), 0);
  for (const Index v : mesh.cornerVertices)
  {
    used[static_cast<std::size_t>(v)] = 1;
  }
  ConnectedComponents components;
  components.ofVertex.assign(mesh.points.size(), NoIndex);
  for (std::size_t v = 0; v < used.size(); ++v)
  {
    if (used[v])
    {
      // The root is the smallest member, so it has its number already.
      const auto root = static_cast<std::size_t>(sets.find(static_cast<Index>(v)));
      components.ofVertex[v] = root == v ? components.count++ : components.ofVertex[root];
    }
  }
  return components;
}

} // namespace evolving
