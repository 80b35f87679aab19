// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Trees/NeedleTree.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

/// Far above the rounding of coordinates, far below anything a triangle could hide behind.
double marginFor(const Box& box)
{
  constexpr double Relative = 1e-12; // of the longest side
  constexpr double Rounding = 8.0 * std::numeric_limits<double>::epsilon();
  const double farthest =
    std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return std::max(Relative * box.sizes().maxCoeff(), Rounding * farthest);
}

} // namespace

void TurnedBoxes::set(int place, const OrientedBox& box, double margin)
{
  for (int k = 0; k < 3; ++k)
  {
    const auto row = static_cast<std::size_t>(k);
    this->Center[row][place] = box.center[k];
    this->HalfSize[row][place] = box.halfSize[k] + margin;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Axis[row][static_cast<std::size_t>(axis)][place] = box.axes(axis, k);
    }
  }
}

class NeedleTreeBuilder
{
public:
  NeedleTreeBuilder(
    NeedleTree& tree, const std::vector<Triangle>& triangles, std::vector<Index> chosen)
    : Tree(tree)
    , Triangles(triangles)
    , Chosen(std::move(chosen))
  {
  }

  void run()
  {
    Box box;
    for (const Index number : this->Chosen)
    {
      box.extend(this->Triangles[at(number)].box());
    }
    if (!box.isEmpty())
    {
      this->Margin = marginFor(box);
      this->Tree.Origin = box.center();
      this->add({ 0, this->Chosen.size() });
    }
  }

private:
  /// Of the chosen ones, [begin, end).
  struct Range
  {
    std::size_t begin;
    std::size_t end;

    std::size_t size() const { return this->end - this->begin; }
  };

  const Triangle& triangle(std::size_t i) const { return this->Triangles[at(this->Chosen[i])]; }

  std::array<Range, 2> halves(const Range& range)
  {
    Box box;
    for (std::size_t i = range.begin; i < range.end; ++i)
    {
      box.extend(this->triangle(i).centroid());
    }
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = range.begin + range.size() / 2;
    const auto place = [this](std::size_t i)
    { return this->Chosen.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(place(range.begin), place(middle), place(range.end),
      [&](Index a, Index b)
      {
        const double p = this->Triangles[at(a)].centroid()[axis];
        const double q = this->Triangles[at(b)].centroid()[axis];
        return p != q ? p < q : a < b;
      });
    return { Range{ range.begin, middle }, Range{ middle, range.end } };
  }

  /// Halves of halves of halves.
  std::vector<Range> partsOf(const Range& range)
  {
    std::vector<Range> parts{ range };
    for (int round = 0; round < 3; ++round)
    {
      std::vector<Range> finer;
      for (const Range& part : parts)
      {
        if (part.size() == 1)
        {
          finer.push_back(part);
          continue;
        }
        const auto two = this->halves(part);
        finer.insert(finer.end(), two.begin(), two.end());
      }
      parts = std::move(finer);
    }
    return parts;
  }

  OrientedBox boxAround(const Range& range) const
  {
    std::vector<const Triangle*> group;
    for (std::size_t i = range.begin; i < range.end; ++i)
    {
      group.push_back(&this->triangle(i));
    }
    OrientedBox box = orientedBoxAround(group);
    box.center -= this->Tree.Origin;
    return box;
  }

  Index add(const Range& range)
  {
    const auto number = static_cast<Index>(this->Tree.Nodes.size());
    this->Tree.Nodes.emplace_back();
    int place = 0;
    for (const Range& part : this->partsOf(range))
    {
      const Index child = part.size() == 1 ? ~this->Chosen[part.begin] : this->add(part);
      NeedleTree::Node& node = this->Tree.Nodes[at(number)];
      node.boxes.set(place, this->boxAround(part), this->Margin);
      node.children[static_cast<std::size_t>(place)] = child;
      node.childCount = ++place;
    }
    return number;
  }

  NeedleTree& Tree;
  const std::vector<Triangle>& Triangles;
  std::vector<Index> Chosen;
  double Margin = 0.0;
};

NeedleTree::NeedleTree(const std::vector<Triangle>& triangles, std::vector<Index> chosen)
{
  NeedleTreeBuilder(*this, triangles, std::move(chosen)).run();
}

} // namespace evolving
