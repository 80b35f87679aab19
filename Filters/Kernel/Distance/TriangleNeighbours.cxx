// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/TriangleNeighbours.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace evolving
{

namespace
{

std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}

/// The faces at every vertex, one vertex after the other.
struct VertexFaces
{
  explicit VertexFaces(const SurfaceMesh& mesh)
    : offsets(mesh.points.size() + 1, 0)
    , faces(mesh.cornerVertices.size())
  {
    for (const Index vertex : mesh.cornerVertices)
    {
      ++this->offsets[at(vertex) + 1];
    }
    std::partial_sum(this->offsets.begin(), this->offsets.end(), this->offsets.begin());
    std::vector<Index> place(this->offsets.begin(), this->offsets.end() - 1);
    for (Index corner = 0; corner < mesh.cornerCount(); ++corner)
    {
      this->faces[at(place[at(mesh.cornerVertices[at(corner)])]++)] = corner / 3;
    }
  }

  std::vector<Index> offsets;
  std::vector<Index> faces;
};

/// The triangles that share a vertex with a face, ascending.
std::vector<Index> touchingFaces(const SurfaceMesh& mesh, const VertexFaces& around, Index face)
{
  std::vector<Index> found;
  for (Index k = 0; k < 3; ++k)
  {
    const std::size_t vertex = at(mesh.faceVertex(face, k));
    const auto first = around.faces.begin() + around.offsets[vertex];
    const auto last = around.faces.begin() + around.offsets[vertex + 1];
    if (last - first <= TriangleNeighbours::LargestFan)
    {
      std::copy_if(first, last, std::back_inserter(found), [face](Index f) { return f != face; });
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// For every triangle the diagonal of the smallest box of the tree that holds it and some others.
std::vector<double> localSizes(const AABBTree& tree)
{
  constexpr Index Some = 8;
  const std::vector<AABBTree::Node>& nodes = tree.nodes();
  // Children come after their parents: counts go up from behind, sizes down from the front.
  std::vector<Index> count(nodes.size());
  for (std::size_t n = nodes.size(); n-- > 0;)
  {
    const AABBTree::Node& node = nodes[n];
    count[n] = node.isLeaf() ? node.triangleCount : count[at(node.left)] + count[at(node.right)];
  }
  std::vector<double> sizeOfNode(
    nodes.size(), nodes.empty() ? 0.0 : nodes[0].box.diagonal().norm());
  std::vector<double> sizeOfTriangle(at(tree.triangleCount()), HUGE_VAL);
  for (std::size_t n = 0; n < nodes.size(); ++n)
  {
    const AABBTree::Node& node = nodes[n];
    sizeOfNode[n] = count[n] >= Some ? node.box.diagonal().norm() : sizeOfNode[n];
    if (!node.isLeaf())
    {
      sizeOfNode[at(node.left)] = sizeOfNode[at(node.right)] = sizeOfNode[n];
    }
    for (Index k = 0; k < node.triangleCount; ++k)
    {
      double& size = sizeOfTriangle[at(tree.leafTriangles()[at(node.firstTriangle + k)])];
      size = std::min(size, sizeOfNode[n]);
    }
  }
  return sizeOfTriangle;
}

/// The triangles in a box about a face, those with the closest boxes if there are many.
std::vector<Index> facesAround(const AABBTree& tree, double size, Index face)
{
  const Box own = tree.triangle(face).box();
  const Vec3 margin = Vec3::Constant(0.5 * size);
  std::vector<Index> found =
    tree.trianglesIn(Box(Vec3(own.min() - margin), Vec3(own.max() + margin)));
  found.erase(std::remove(found.begin(), found.end(), face), found.end());
  const auto distance = [&](Index other)
  { return (tree.triangle(other).box().center() - own.center()).squaredNorm(); };
  std::stable_sort(
    found.begin(), found.end(), [&](Index a, Index b) { return distance(a) < distance(b); });
  found.resize(std::min(found.size(), at(TriangleNeighbours::LargestFan)));
  return found;
}

} // namespace

TriangleNeighbours::TriangleNeighbours(
  const SurfaceMesh& mesh, const AABBTree& tree, const Execution& execution)
{
  constexpr std::size_t Few = 3;
  const VertexFaces around(mesh);
  const std::vector<double> sizes = localSizes(tree);
  std::vector<std::vector<Index>> lists(at(mesh.faceCount()));
  execution.forRangeReporting(mesh.faceCount(), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto face = static_cast<Index>(begin); face < static_cast<Index>(end); ++face)
      {
        lists[at(face)] = touchingFaces(mesh, around, face);
        if (lists[at(face)].size() < Few)
        {
          lists[at(face)] = facesAround(tree, sizes[at(face)], face);
        }
      }
    });
  this->join(lists);
}

void TriangleNeighbours::join(const std::vector<std::vector<Index>>& lists)
{
  this->Offsets.reserve(lists.size() + 1);
  for (const std::vector<Index>& list : lists)
  {
    this->Offsets.push_back(this->Offsets.back() + list.size());
  }
  this->Neighbours.reserve(this->Offsets.back());
  for (const std::vector<Index>& list : lists)
  {
    this->Neighbours.insert(this->Neighbours.end(), list.begin(), list.end());
  }
}

} // namespace evolving
