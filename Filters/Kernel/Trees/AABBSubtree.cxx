// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/AABBSubtree.h"

#include "Trees/AABBTree.h"

#include <utility>

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

FloatBox boxAround(const TriangleReferences& references)
{
  FloatBox box;
  for (const TriangleReference& reference : references)
  {
    box.extend(reference.box);
  }
  return box;
}

AABBSubtree AABBSubtreeBuilder::build(TriangleReferences references, int level)
{
  this->Result = {};
  this->addNode(references, level);
  return std::move(this->Result);
}

Index AABBSubtreeBuilder::addNode(TriangleReferences& references, int level)
{
  const auto node = static_cast<Index>(this->Result.nodes.size());
  this->Result.nodes.emplace_back();
  const FloatBox box = boxAround(references);
  this->Result.nodes.back().box = this->nodeBox(box);
  this->Result.levels.push_back(static_cast<std::int8_t>(level));
  TriangleReferences left;
  TriangleReferences right;
  if (!this->split(references, box, level, left, right))
  {
    this->fillLeaf(node, references);
    return node;
  }
  TriangleReferences().swap(references); // the halves replace it
  const Index leftNode = this->addNode(left, level + 1);
  const Index rightNode = this->addNode(right, level + 1);
  this->Result.nodes[static_cast<std::size_t>(node)].left = leftNode;
  this->Result.nodes[static_cast<std::size_t>(node)].right = rightNode;
  return node;
}

bool AABBSubtreeBuilder::split(const TriangleReferences& references, const FloatBox& box, int level,
  TriangleReferences& left, TriangleReferences& right)
{
  if (references.size() <= AABBTree::LargestLeaf || level >= AABBTree::MaximumDepth)
  {
    return false;
  }
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
  for (const TriangleReference& reference : references)
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

void AABBSubtreeBuilder::clip(
  TriangleReference& left, TriangleReference& right, int axis, float position) const
{
  const Triangle& triangle = this->Triangles[static_cast<std::size_t>(left.triangle)];
  const auto plane = static_cast<double>(position);
  Box below;
  Box above;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec3 from = this->Frame.local(triangle.corners[k]);
    const Vec3 to = this->Frame.local(triangle.corners[(k + 1) % 3]);
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

void AABBSubtreeBuilder::fillLeaf(Index node, const TriangleReferences& references)
{
  BoxNode& leaf = this->Result.nodes[static_cast<std::size_t>(node)];
  leaf.firstTriangle = static_cast<Index>(this->Result.leafTriangles.size());
  for (const TriangleReference& reference : references)
  {
    if (overlaps(this->Triangles[static_cast<std::size_t>(reference.triangle)], leaf.box))
    {
      this->Result.leafTriangles.push_back(reference.triangle);
      this->Result.leafBoxes.push_back(roundedOutwards(this->inflated(reference.box)));
    }
  }
  leaf.triangleCount = static_cast<Index>(this->Result.leafTriangles.size()) - leaf.firstTriangle;
}

Box AABBSubtreeBuilder::inflated(const FloatBox& box) const
{
  const Vec3 margin = Vec3::Constant(this->Epsilon);
  return { Vec3(box.min().cast<double>() - margin), Vec3(box.max().cast<double>() + margin) };
}

} // namespace evolving
