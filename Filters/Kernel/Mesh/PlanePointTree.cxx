// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PlanePointTree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace evolving
{

namespace
{

constexpr Index LargestLeaf = 8;

} // namespace

PlanePointTree::PlanePointTree(std::vector<Vec2> points)
  : Points(std::move(points))
  , Order(this->Points.size())
  , Place(this->Points.size())
  , IsOut(this->Points.size(), 0)
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  this->addNode(0, static_cast<Index>(this->Order.size()));
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    this->Place[at(this->Order[i])] = static_cast<Index>(i);
  }
}

Index PlanePointTree::addNode(Index begin, Index end)
{
  const auto number = static_cast<Index>(this->Nodes.size());
  Node node;
  node.begin = begin;
  node.end = end;
  node.left = end - begin;
  for (Index i = begin; i < end; ++i)
  {
    node.box.extend(this->Points[at(this->Order[at(i)])]);
  }
  this->Nodes.push_back(node);
  if (end - begin <= LargestLeaf)
  {
    return number;
  }
  int axis = 0;
  node.box.sizes().maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(this->Order.begin() + begin, this->Order.begin() + middle,
    this->Order.begin() + end,
    [&](Index a, Index b) { return this->Points[at(a)][axis] < this->Points[at(b)][axis]; });
  this->addNode(begin, middle);
  const Index right = this->addNode(middle, end);
  this->Nodes[at(number)].right = right;
  return number;
}

void PlanePointTree::remove(Index point)
{
  this->IsOut[at(point)] = 1;
  for (Index number = 0;;)
  {
    Node& node = this->Nodes[at(number)];
    --node.left;
    if (node.right == NoIndex)
    {
      return;
    }
    const bool isRight = this->Place[at(point)] >= this->Nodes[at(node.right)].begin;
    number = isRight ? node.right : number + 1;
  }
}

PlanePointTree::Wedge::Wedge(const std::array<Vec2, 3>& corners, double size)
{
  // Some roundings of coordinates, which are as large as all points together.
  constexpr double Rounding = 1e-14;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec2& from = corners[k];
    const Vec2 along = corners[(k + 1) % 3] - from;
    this->Bounds.extend(from);
    this->Inwards[k] = Vec2(-along.y(), along.x());
    this->Least[k] = this->Inwards[k].dot(from) - Rounding * size * along.cwiseAbs().sum();
  }
  const Vec2 margin = Vec2::Constant(Rounding * size);
  this->Bounds = Box2(this->Bounds.min() - margin, this->Bounds.max() + margin);
}

bool PlanePointTree::Wedge::meets(const Box2& box) const
{
  if (!this->Bounds.intersects(box))
  {
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vec2& inwards = this->Inwards[k];
    const Vec2 farthest(inwards.x() > 0.0 ? box.max().x() : box.min().x(),
      inwards.y() > 0.0 ? box.max().y() : box.min().y());
    if (inwards.dot(farthest) < this->Least[k])
    {
      return false;
    }
  }
  return true;
}

} // namespace evolving
