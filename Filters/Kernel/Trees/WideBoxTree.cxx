// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/WideBoxTree.h"

#include <algorithm>
#include <limits>

namespace evolving
{

BoxRow::BoxRow()
{
  constexpr float Infinity = std::numeric_limits<float>::infinity();
  this->Minimum.fill(Lanes::Constant(Infinity));
  this->Maximum.fill(Lanes::Constant(-Infinity));
}

void BoxRow::set(int place, const FloatBox& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Minimum[static_cast<std::size_t>(axis)][place] = box.min()[axis];
    this->Maximum[static_cast<std::size_t>(axis)][place] = box.max()[axis];
  }
}

class WideBoxTreeBuilder
{
public:
  WideBoxTreeBuilder(WideBoxTree& tree, const std::vector<BoxNode>& nodes,
    const std::vector<Index>& leafTriangles, const std::vector<FloatBox>& leafBoxes)
    : Tree(tree)
    , Nodes(nodes)
    , LeafTriangles(leafTriangles)
    , LeafBoxes(leafBoxes)
  {
  }

  void run()
  {
    if (!this->Nodes.empty())
    {
      this->add(0);
    }
  }

private:
  /// A node of the binary tree, or a triangle of a leaf; its box in the root's frame.
  struct Part
  {
    Box box;
    Index node;
    Index triangle;
  };
  using Parts = std::vector<Part>;

  static constexpr std::size_t Width = BoxRow::Length;

  const BoxNode& node(Index number) const { return this->Nodes[static_cast<std::size_t>(number)]; }

  void appendPartsOf(Index number, Parts& parts) const
  {
    const BoxNode& node = this->node(number);
    for (const Index child : { node.left, node.right })
    {
      if (child != NoIndex)
      {
        parts.push_back({ this->Tree.Frame.local(this->node(child).box), child, NoIndex });
      }
    }
    for (Index k = node.firstTriangle; k < node.firstTriangle + node.triangleCount; ++k)
    {
      const auto entry = static_cast<std::size_t>(k);
      parts.push_back(
        { this->LeafBoxes[entry].cast<double>(), NoIndex, this->LeafTriangles[entry] });
    }
  }

  std::size_t partCount(const Part& part) const
  {
    const BoxNode& node = this->node(part.node);
    return node.isLeaf() ? static_cast<std::size_t>(node.triangleCount) : 2;
  }

  /// Takes the largest nodes apart while their parts find room.
  void fill(Parts& parts) const
  {
    const auto size = [&](const Part& part)
    {
      const bool fits = part.node != NoIndex && parts.size() - 1 + this->partCount(part) <= Width;
      return fits ? part.box.diagonal().squaredNorm() : -1.0;
    };
    for (;;)
    {
      const auto largest = std::max_element(parts.begin(), parts.end(),
        [&](const Part& a, const Part& b) { return size(a) < size(b); });
      if (largest == parts.end() || size(*largest) < 0.0)
      {
        return;
      }
      const Index number = largest->node;
      *largest = parts.back();
      parts.pop_back();
      this->appendPartsOf(number, parts);
    }
  }

  Index add(Index number)
  {
    Parts parts;
    parts.reserve(Width);
    this->appendPartsOf(number, parts);
    this->fill(parts);
    return this->add(parts);
  }

  /// A node of these parts, or of groups of them where they are many.
  Index add(const Parts& parts)
  {
    const auto number = static_cast<Index>(this->Tree.Nodes.size());
    this->Tree.Nodes.emplace_back();
    if (parts.size() <= Width)
    {
      for (const Part& part : parts)
      {
        this->append(number, this->childOf(part), part.box);
      }
      return number;
    }
    for (std::size_t group = 0; group < Width; ++group)
    {
      const auto begin = static_cast<std::ptrdiff_t>(group * parts.size() / Width);
      const auto end = static_cast<std::ptrdiff_t>((group + 1) * parts.size() / Width);
      const Parts some(parts.begin() + begin, parts.begin() + end);
      this->append(number, this->add(some), boxOf(some));
    }
    return number;
  }

  void append(Index number, Index child, const Box& box)
  {
    WideBoxTree::Node& node = this->Tree.Nodes[static_cast<std::size_t>(number)];
    node.boxes.set(node.childCount, roundedOutwards(box));
    node.children[static_cast<std::size_t>(node.childCount)] = child;
    ++node.childCount;
  }

  Index childOf(const Part& part)
  {
    return part.node == NoIndex ? ~part.triangle : this->add(part.node);
  }

  static Box boxOf(const Parts& parts)
  {
    Box box;
    for (const Part& part : parts)
    {
      box.extend(part.box);
    }
    return box;
  }

  WideBoxTree& Tree;
  const std::vector<BoxNode>& Nodes;
  const std::vector<Index>& LeafTriangles;
  const std::vector<FloatBox>& LeafBoxes;
};

WideBoxTree::WideBoxTree(const std::vector<BoxNode>& nodes, const std::vector<Index>& leafTriangles,
  const std::vector<FloatBox>& leafBoxes, const RootFrame& frame)
  : Frame(frame)
{
  WideBoxTreeBuilder(*this, nodes, leafTriangles, leafBoxes).run();
}

} // namespace evolving
