// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/AABBTree.h"

#include "Distance/AABBTreeBuilder.h"
#include "Errors.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace evolving
{

namespace
{

/// A node still to be looked at. Depth first, there is at most one per level and one more.
struct Pending
{
  Index node;
  double squaredDistance;
};

/// A stack of fixed size: queries allocate nothing.
template <typename Entry>
class TraversalStack
{
public:
  bool isEmpty() const { return this->Size == 0; }
  void push(const Entry& entry) { this->Entries[this->Size++] = entry; }
  Entry pop() { return this->Entries[--this->Size]; }

private:
  std::array<Entry, AABBTree::MaximumDepth + 2> Entries;
  std::size_t Size = 0;
};

/// Calls visit(leaf) for the leaves whose boxes, and whose parents' boxes, pass; until it
/// returns true.
template <typename Passes, typename Visit>
void visitLeaves(const std::vector<AABBTree::Node>& nodes, Passes passes, Visit visit)
{
  TraversalStack<Index> stack;
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

/// Nearer, or as near and of a smaller number; NoIndex, as an unsigned number, is the largest.
bool isCloser(const TrianglePoint& at, Index triangle, const ClosestTriangle& best)
{
  return at.squaredDistance < best.at.squaredDistance ||
    (at.squaredDistance == best.at.squaredDistance &&
      static_cast<std::uint32_t>(triangle) < static_cast<std::uint32_t>(best.triangle));
}

} // namespace

AABBTree::AABBTree(const SurfaceMesh& mesh, const Execution& execution)
{
  this->Triangles.reserve(static_cast<std::size_t>(mesh.faceCount()));
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (mesh.faceSize(face) != 3)
    {
      std::ostringstream message;
      message << "Face " << face << " has " << mesh.faceSize(face)
              << " corners, expected 3; triangulate the mesh before building a tree.";
      throw InputError(message.str());
    }
    this->Triangles.push_back(
      { { mesh.facePoint(face, 0), mesh.facePoint(face, 1), mesh.facePoint(face, 2) } });
  }
  AABBTreeBuilder::build(*this, execution);
}

void AABBTree::visitLeaf(const Node& leaf, const Vec3& point, ClosestTriangle& best) const
{
  const Index* triangles = this->LeafTriangles.data() + leaf.firstTriangle;
  for (Index k = 0; k < leaf.triangleCount; ++k)
  {
    const TrianglePoint at = closestPointOnTriangle(point, this->triangle(triangles[k]));
    if (isCloser(at, triangles[k], best))
    {
      best = { triangles[k], at };
    }
  }
}

ClosestTriangle AABBTree::closest(const Vec3& point, double squaredBound, Index guess) const
{
  ClosestTriangle best;
  best.at.squaredDistance = squaredBound;
  if (this->isEmpty())
  {
    return best;
  }
  if (guess != NoIndex)
  {
    const TrianglePoint at = closestPointOnTriangle(point, this->triangle(guess));
    best = at.squaredDistance <= squaredBound ? ClosestTriangle{ guess, at } : best;
  }
  TraversalStack<Pending> stack;
  stack.push({ 0, this->Nodes.front().box.squaredExteriorDistance(point) });
  while (!stack.isEmpty())
  {
    const Pending pending = stack.pop();
    if (pending.squaredDistance > best.at.squaredDistance)
    {
      continue;
    }
    const Node& node = this->Nodes[static_cast<std::size_t>(pending.node)];
    if (node.isLeaf())
    {
      this->visitLeaf(node, point, best);
      continue;
    }
    const auto pendingChild = [&](Index child)
    {
      const Box& box = this->Nodes[static_cast<std::size_t>(child)].box;
      return Pending{ child, box.squaredExteriorDistance(point) };
    };
    const Pending left = pendingChild(node.left);
    const Pending right = pendingChild(node.right);
    const bool leftFirst = left.squaredDistance <= right.squaredDistance;
    stack.push(leftFirst ? right : left);
    stack.push(leftFirst ? left : right);
  }
  return best;
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
        if (const auto parameter = ray.hit(this->triangle(triangles[k])))
        {
          found.push_back({ triangles[k], *parameter });
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
