// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/AABBTree.h"

#include "Errors.h"
#include "Trees/AABBTreeBuilder.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace evolving
{

namespace
{

/// A stack of fixed size: queries allocate nothing. Depth first, there is at most one node per
/// level and one more.
class TraversalStack
{
public:
  bool isEmpty() const { return this->Size == 0; }
  void push(Index node) { this->Nodes[this->Size++] = node; }
  Index pop() { return this->Nodes[--this->Size]; }

private:
  std::array<Index, AABBTree::MaximumDepth + 2> Nodes;
  std::size_t Size = 0;
};

/// Calls visit(leaf) for the leaves whose boxes, and whose parents' boxes, pass; until it
/// returns true.
template <typename Passes, typename Visit>
void visitLeaves(const std::vector<AABBTree::Node>& nodes, Passes passes, Visit visit)
{
  TraversalStack stack;
  if (!nodes.empty())
  {
    stack.push(0);
  }
  while (!stack.isEmpty())
  {
    const AABBTree::Node& node = nodes[static_cast<std::size_t>(stack.pop())];
    if (!passes(node.box))
    {
      continue;
    }
    if (!node.isLeaf())
    {
      stack.push(node.right);
      stack.push(node.left);
    }
    else if (visit(node))
    {
      return;
    }
  }
}

/// A triangle and its squared distance.
struct Candidate
{
  Index triangle;
  double squaredDistance;
};

/// Nearer, or as near and of a smaller number; NoIndex, as an unsigned number, is the largest.
bool isCloser(const Candidate& a, const Candidate& b)
{
  return a.squaredDistance < b.squaredDistance ||
    (a.squaredDistance == b.squaredDistance &&
      static_cast<std::uint32_t>(a.triangle) < static_cast<std::uint32_t>(b.triangle));
}

} // namespace

AABBTree::AABBTree(const SurfaceMesh& mesh, const Execution& execution)
{
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (mesh.faceSize(face) != 3)
    {
      std::ostringstream message;
      message << "Face " << face << " has " << mesh.faceSize(face)
              << " corners, expected 3; triangulate the mesh before building a tree.";
      throw InputError(message.str());
    }
  }
  this->Triangles = trianglesOf(mesh);
  this->Measured.reserve(this->Triangles.size());
  for (const Triangle& triangle : this->Triangles)
  {
    this->Measured.emplace_back(triangle);
  }
  AABBTreeBuilder::build(*this, execution);
}

Box AABBTree::bounds() const
{
  Box box;
  for (const Triangle& triangle : this->Triangles)
  {
    box.extend(triangle.box());
  }
  return box;
}

ClosestTriangle AABBTree::closest(const Vec3& point, double squaredBound, Index guess) const
{
  Candidate best{ NoIndex, squaredBound };
  const auto consider = [&](Index triangle)
  {
    const Candidate candidate{ triangle, this->squaredDistance(triangle, point) };
    best = isCloser(candidate, best) ? candidate : best;
  };
  if (guess >= 0 && guess < this->triangleCount())
  {
    consider(guess);
  }
  this->visitNear(point, best.squaredDistance,
    [&](Index triangle)
    {
      if (triangle != best.triangle)
      {
        consider(triangle);
      }
      return best.squaredDistance;
    });
  if (best.triangle == NoIndex)
  {
    return {};
  }
  return { best.triangle, closestPointOnTriangle(point, this->triangle(best.triangle)) };
}

bool AABBTree::meets(const Box& box) const
{
  bool found = false;
  visitLeaves(
    this->Nodes, [&box](const Box& nodeBox) { return nodeBox.intersects(box); },
    [&](const Node& leaf)
    {
      const Index* triangles = this->LeafTriangles.data() + leaf.firstTriangle;
      found = std::any_of(triangles, triangles + leaf.triangleCount,
        [&](Index triangle) { return overlaps(this->triangle(triangle), box); });
      return found;
    });
  return found;
}

std::vector<Index> AABBTree::trianglesIn(const Box& box) const
{
  std::vector<Index> found;
  visitLeaves(
    this->Nodes, [&box](const Box& nodeBox) { return nodeBox.intersects(box); },
    [&](const Node& leaf)
    {
      const Index* triangles = this->LeafTriangles.data() + leaf.firstTriangle;
      std::copy_if(triangles, triangles + leaf.triangleCount, std::back_inserter(found),
        [&](Index triangle) { return overlaps(this->triangle(triangle), box); });
      return false;
    });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<RayHit> AABBTree::hits(const Ray& ray) const
{
  std::vector<RayHit> found;
  visitLeaves(
    this->Nodes, [&ray](const Box& nodeBox) { return ray.meets(nodeBox); },
    [&](const Node& leaf)
    {
      const Index* triangles = this->LeafTriangles.data() + leaf.firstTriangle;
      for (Index k = 0; k < leaf.triangleCount; ++k)
      {
        if (const auto crossing = ray.crossing(this->triangle(triangles[k])))
        {
          found.push_back({ triangles[k], crossing->parameter, crossing->isFromBehind });
        }
      }
      return false;
    });
  const auto order = [](const RayHit& a, const RayHit& b)
  { return a.parameter != b.parameter ? a.parameter < b.parameter : a.triangle < b.triangle; };
  std::sort(found.begin(), found.end(), order);
  const auto same = [](const RayHit& a, const RayHit& b) { return a.triangle == b.triangle; };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return found;
}

} // namespace evolving
