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

/// The squared distance from a point to a box, 0 inside.
template <typename Scalar>
inline double squaredGap(const Eigen::AlignedBox<Scalar, 3>& box, const Vec3& point)
{
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double below = static_cast<double>(box.min()[axis]) - point[axis];
    const double above = point[axis] - static_cast<double>(box.max()[axis]);
    const double gap = std::max(std::max(below, above), 0.0);
    sum += gap * gap;
  }
  return sum;
}

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
template <typename Candidate>
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

void AABBTree::visitLeaf(const Node& leaf, const Vec3& point, Candidate& best) const
{
  const Index* triangles = this->LeafTriangles.data() + leaf.firstTriangle;
  const Eigen::AlignedBox3f* boxes = this->LeafBoxes.data() + leaf.firstTriangle;
  for (Index k = 0; k < leaf.triangleCount; ++k)
  {
    if (triangles[k] != best.triangle && squaredGap(boxes[k], point) <= best.squaredDistance)
    {
      const Candidate candidate{ triangles[k], this->squaredDistance(triangles[k], point) };
      best = isCloser(candidate, best) ? candidate : best;
    }
  }
}

ClosestTriangle AABBTree::closest(const Vec3& point, double squaredBound, Index guess) const
{
  Candidate best{ NoIndex, squaredBound };
  if (this->isEmpty())
  {
    return {};
  }
  if (guess >= 0 && guess < this->triangleCount())
  {
    const Candidate candidate{ guess, this->squaredDistance(guess, point) };
    best = isCloser(candidate, best) ? candidate : best;
  }
  TraversalStack<Pending> stack;
  stack.push({ 0, squaredGap(this->Nodes.front().box, point) });
  while (!stack.isEmpty())
  {
    const Pending pending = stack.pop();
    if (pending.squaredDistance > best.squaredDistance)
    {
      continue;
    }
    const Node& node = this->Nodes[static_cast<std::size_t>(pending.node)];
    if (node.isLeaf())
    {
      this->visitLeaf(node, point, best);
      continue;
    }
    const auto child = [&](Index number) -> Pending {
      return { number, squaredGap(this->Nodes[static_cast<std::size_t>(number)].box, point) };
    };
    const Pending left = child(node.left);
    const Pending right = child(node.right);
    const bool leftFirst = left.squaredDistance <= right.squaredDistance;
    stack.push(leftFirst ? right : left);
    stack.push(leftFirst ? left : right);
  }
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
