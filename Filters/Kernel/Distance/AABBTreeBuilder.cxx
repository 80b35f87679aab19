// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/AABBTreeBuilder.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// Intersects a box with one inflated by a margin, unless nothing would remain.
void shrink(FloatBox& box, const Box& other, double margin)
{
  const Vec3 size = Vec3::Constant(margin);
  const FloatBox common =
    box.intersection(roundedOutwards(Box(Vec3(other.min() - size), Vec3(other.max() + size))));
  box = common.isEmpty() ? box : common;
}

} // namespace

void AABBTreeBuilder::build(AABBTree& tree, const Execution& execution)
{
  AABBTreeBuilder builder(tree, execution);
  References references = builder.allTriangles();
  if (!references.empty())
  {
    builder.addNode(references, 0);
    tree.Near = WideBoxTree(tree.Nodes, tree.LeafTriangles, builder.LeafBoxes);
  }
  execution.report(1.0);
}

AABBTreeBuilder::AABBTreeBuilder(AABBTree& tree, const Execution& execution)
  : Tree(tree)
  , Host(execution)
{
  Box root;
  for (const Triangle& triangle : tree.Triangles)
  {
    root.extend(triangle.box());
  }
  // Far above the rounding of coordinates, far below anything a triangle could hide behind.
  constexpr double RelativeEpsilon = 1e-7;
  this->Epsilon = root.isEmpty() ? 0.0 : RelativeEpsilon * root.sizes().maxCoeff();
}

AABBTreeBuilder::References AABBTreeBuilder::allTriangles() const
{
  References references(this->Tree.Triangles.size());
  for (std::size_t i = 0; i < references.size(); ++i)
  {
    references[i] = { static_cast<Index>(i), roundedOutwards(this->Tree.Triangles[i].box()) };
  }
  return references;
}

Index AABBTreeBuilder::addNode(References& references, int level)
{
  FloatBox box;
  for (const Reference& reference : references)
  {
    box.extend(reference.box);
  }
  const auto node = static_cast<Index>(this->Tree.Nodes.size());
  this->Tree.Nodes.emplace_back();
  this->Tree.Nodes.back().box = this->inflated(box);
  this->Tree.Levels.push_back(static_cast<std::int8_t>(level));
  this->reportProgress(references.size());

  References left;
  References right;
  if (references.size() <= AABBTree::LargestLeaf || level >= AABBTree::MaximumDepth ||
    !this->split(references, box, left, right))
  {
    this->fillLeaf(node, references);
    return node;
  }
  References().swap(references); // the halves replace it; only one path is in memory
  const Index leftNode = this->addNode(left, level + 1);
  const Index rightNode = this->addNode(right, level + 1);
  this->Tree.Nodes[static_cast<std::size_t>(node)].left = leftNode;
  this->Tree.Nodes[static_cast<std::size_t>(node)].right = rightNode;
  return node;
}

bool AABBTreeBuilder::split(
  const References& references, const FloatBox& box, References& left, References& right)
{
  int axis = 0;
  const float length = box.sizes().maxCoeff(&axis);
  if (!(length > 0.0F))
  {
    return false; // copies of one point
  }
  const float low = box.min()[axis];
  this->Intervals.resize(references.size());
  for (std::size_t i = 0; i < references.size(); ++i)
  {
    this->Intervals[i] = { (references[i].box.min()[axis] - low) / length,
      (references[i].box.max()[axis] - low) / length };
  }
  const float fraction = searchSplit(box.sizes().cast<double>(), axis, this->Intervals).position;
  const float position = low + fraction * length;
  for (const Reference& reference : references)
  {
    const float from = reference.box.min()[axis];
    const float to = reference.box.max()[axis];
    const bool isLeft = from < position || to <= position;
    const bool isRight = to > position;
    if (isLeft)
    {
      left.push_back(reference);
    }
    if (isRight)
    {
      right.push_back(reference);
    }
    if (isLeft && isRight)
    {
      this->clip(left.back(), right.back(), axis, position);
    }
  }
  const auto before = static_cast<double>(references.size());
  return static_cast<double>(left.size() + right.size()) < AABBTree::LargestGrowth * before &&
    left.size() < references.size() && right.size() < references.size();
}

void AABBTreeBuilder::clip(Reference& left, Reference& right, int axis, float position) const
{
  const Triangle& triangle = this->Tree.triangle(left.triangle);
  const auto plane = static_cast<double>(position);
  Box below;
  Box above;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3& from = triangle.corners[k];
    const Vec3& to = triangle.corners[(k + 1) % 3];
    // A corner in the plane belongs to both parts.
    if (from[axis] <= plane)
    {
      below.extend(from);
    }
    if (from[axis] >= plane)
    {
      above.extend(from);
    }
    if ((from[axis] < plane && to[axis] > plane) || (from[axis] > plane && to[axis] < plane))
    {
      const double t = (plane - from[axis]) / (to[axis] - from[axis]);
      const Vec3 crossing = from + t * (to - from);
      below.extend(crossing);
      above.extend(crossing);
    }
  }
  left.box.max()[axis] = position;
  right.box.min()[axis] = position;
  shrink(left.box, below, this->Epsilon);
  shrink(right.box, above, this->Epsilon);
}

void AABBTreeBuilder::fillLeaf(Index node, const References& references)
{
  AABBTree::Node& leaf = this->Tree.Nodes[static_cast<std::size_t>(node)];
  leaf.firstTriangle = static_cast<Index>(this->Tree.LeafTriangles.size());
  for (const Reference& reference : references)
  {
    if (overlaps(this->Tree.triangle(reference.triangle), leaf.box))
    {
      this->Tree.LeafTriangles.push_back(reference.triangle);
      this->LeafBoxes.push_back(roundedOutwards(this->inflated(reference.box)));
    }
  }
  leaf.triangleCount = static_cast<Index>(this->Tree.LeafTriangles.size()) - leaf.firstTriangle;
  this->Finished += references.size();
}

Box AABBTreeBuilder::inflated(const FloatBox& box) const
{
  const Vec3 margin = Vec3::Constant(this->Epsilon);
  return { Vec3(box.min().cast<double>() - margin), Vec3(box.max().cast<double>() + margin) };
}

void AABBTreeBuilder::reportProgress(std::size_t finishedReferences)
{
  constexpr std::size_t ReportInterval = 200000; // some ten milliseconds
  this->SinceReport += finishedReferences;
  if (this->SinceReport >= ReportInterval)
  {
    this->SinceReport = 0;
    // A triangle ends up in about three leaves.
    const double expected = 3.0 * static_cast<double>(this->Tree.Triangles.size());
    this->Host.report(static_cast<double>(this->Finished) / expected);
  }
}

} // namespace evolving
