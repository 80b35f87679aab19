// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/AABBTreeBuilder.h"

#include "ParallelLoops.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

/// Far above the rounding of coordinates, far below anything a triangle could hide behind.
double epsilonFor(const Box& root, const RootFrame& frame)
{
  constexpr double RelativeEpsilon = 1e-7; // of the longest side
  // Nodes are handed out in the model's coordinates, which may be far coarser than the model.
  constexpr double Rounding = 4.0 * std::numeric_limits<double>::epsilon();
  const double farthest =
    std::max(root.min().cwiseAbs().maxCoeff(), root.max().cwiseAbs().maxCoeff());
  const double epsilon = std::max(RelativeEpsilon * root.sizes().maxCoeff(), Rounding * farthest);
  return frame.inverseHalfSize() * epsilon;
}

/// Leaves are tested in rows of eight boxes side by side, and up to eight rows as quickly as turned
/// boxes are, measured on revolved profiles. Larger ones are needles, or triangles on each other,
/// that no plane across an axis parts.
bool isCrowded(const BoxNode& node)
{
  return node.triangleCount > BoxRow::Length * BoxRow::Length;
}

} // namespace

void AABBTreeBuilder::build(AABBTree& tree, const Execution& execution)
{
  AABBTreeBuilder builder(tree, execution);
  TriangleReferences references = builder.allTriangles();
  if (!references.empty())
  {
    builder.addUpper(std::move(references), 0);
    builder.buildSubtrees();
    builder.append(builder.Upper.front());
    tree.Needles = NeedleTree(tree.Triangles, builder.crowdedTriangles());
    tree.Near =
      WideBoxTree(builder.uncrowdedNodes(), tree.LeafTriangles, builder.LeafBoxes, builder.Frame);
  }
  execution.report(1.0);
}

AABBTreeBuilder::AABBTreeBuilder(AABBTree& tree, const Execution& execution)
  : Tree(tree)
  , Run(execution)
{
  const Box root = tree.bounds();
  if (!root.isEmpty())
  {
    this->Frame = RootFrame(root);
    this->Epsilon = epsilonFor(root, this->Frame);
  }
}

std::vector<Index> AABBTreeBuilder::crowdedTriangles() const
{
  std::vector<Index> crowded;
  for (const BoxNode& node : this->Tree.Nodes)
  {
    if (isCrowded(node))
    {
      const auto first = this->Tree.LeafTriangles.begin() + node.firstTriangle;
      crowded.insert(crowded.end(), first, first + node.triangleCount);
    }
  }
  std::sort(crowded.begin(), crowded.end());
  crowded.erase(std::unique(crowded.begin(), crowded.end()), crowded.end());
  return crowded;
}

std::vector<BoxNode> AABBTreeBuilder::uncrowdedNodes() const
{
  std::vector<BoxNode> nodes = this->Tree.Nodes;
  for (BoxNode& node : nodes)
  {
    node.triangleCount = isCrowded(node) ? 0 : node.triangleCount;
  }
  return nodes;
}

TriangleReferences AABBTreeBuilder::allTriangles() const
{
  TriangleReferences references(this->Tree.Triangles.size());
  forEachIndex(this->Run, this->Tree.triangleCount(),
    [&](Index i) {
      references[at(i)] = { i, roundedOutwards(this->Frame.local(this->Tree.triangle(i).box())) };
    });
  return references;
}

std::size_t AABBTreeBuilder::addUpper(TriangleReferences references, int level)
{
  constexpr int UpperLevels = 6;
  constexpr std::size_t WorthAThread = 1000;
  this->Run.report(0.0);
  AABBSubtreeBuilder builder(this->Tree.Triangles, this->Frame, this->Epsilon);
  const std::size_t number = this->Upper.size();
  this->Upper.emplace_back();
  this->Upper[number].level = level;
  const FloatBox box = boxAround(references);
  TriangleReferences left;
  TriangleReferences right;
  if (level < UpperLevels && references.size() > WorthAThread &&
    builder.split(references, box, level, left, right))
  {
    this->Upper[number].box = builder.nodeBox(box);
    TriangleReferences().swap(references);
    const std::size_t leftNumber = this->addUpper(std::move(left), level + 1);
    const std::size_t rightNumber = this->addUpper(std::move(right), level + 1);
    this->Upper[number].left = leftNumber;
    this->Upper[number].right = rightNumber;
  }
  else
  {
    this->Upper[number].references = std::move(references);
  }
  return number;
}

void AABBTreeBuilder::buildSubtrees()
{
  this->Run.forRangeReporting(static_cast<std::int64_t>(this->Upper.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        UpperNode& upper = this->Upper[static_cast<std::size_t>(i)];
        if (!upper.hasHalves())
        {
          AABBSubtreeBuilder builder(this->Tree.Triangles, this->Frame, this->Epsilon);
          upper.subtree = builder.build(std::move(upper.references), upper.level);
        }
      }
    });
}

Index AABBTreeBuilder::append(const UpperNode& upper)
{
  if (!upper.hasHalves())
  {
    return this->append(upper.subtree);
  }
  const auto node = static_cast<Index>(this->Tree.Nodes.size());
  this->Tree.Nodes.emplace_back();
  this->Tree.Nodes.back().box = upper.box;
  this->Tree.Levels.push_back(static_cast<std::int8_t>(upper.level));
  const Index left = this->append(this->Upper[upper.left]);
  const Index right = this->append(this->Upper[upper.right]);
  this->Tree.Nodes[at(node)].left = left;
  this->Tree.Nodes[at(node)].right = right;
  return node;
}

Index AABBTreeBuilder::append(const AABBSubtree& subtree)
{
  const auto node = static_cast<Index>(this->Tree.Nodes.size());
  const auto leafTriangle = static_cast<Index>(this->Tree.LeafTriangles.size());
  for (BoxNode next : subtree.nodes)
  {
    next.left += next.isLeaf() ? 0 : node;
    next.right += next.right == NoIndex ? 0 : node;
    next.firstTriangle += next.isLeaf() ? leafTriangle : 0;
    this->Tree.Nodes.push_back(next);
  }
  const auto addTo = [](auto& all, const auto& some)
  { all.insert(all.end(), some.begin(), some.end()); };
  addTo(this->Tree.Levels, subtree.levels);
  addTo(this->Tree.LeafTriangles, subtree.leafTriangles);
  addTo(this->LeafBoxes, subtree.leafBoxes);
  return node;
}

} // namespace evolving
