// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/WindingNumber.h"

#include "Mesh/Angles.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

constexpr double FourPi = 4.0 * Pi;

/// Sorts the triangles so that those before `middle` lie before the others along the longest
/// axis of their centroids' box.
void splitAtMedian(std::vector<Triangle>& triangles, Index begin, Index middle, Index end)
{
  Box box;
  for (Index i = begin; i < end; ++i)
  {
    box.extend(triangles[static_cast<std::size_t>(i)].centroid());
  }
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  std::nth_element(triangles.begin() + begin, triangles.begin() + middle, triangles.begin() + end,
    [axis](const Triangle& a, const Triangle& b)
    { return a.centroid()[axis] < b.centroid()[axis]; });
}

} // namespace

double windingNumber(const Triangle& triangle, const Vec3& point)
{
  const Vec3 a = triangle.corners[0] - point;
  const Vec3 b = triangle.corners[1] - point;
  const Vec3 c = triangle.corners[2] - point;
  const double lengthA = a.norm();
  const double lengthB = b.norm();
  const double lengthC = c.norm();
  const double numerator = a.dot(b.cross(c));
  const double denominator =
    lengthA * lengthB * lengthC + a.dot(b) * lengthC + b.dot(c) * lengthA + c.dot(a) * lengthB;
  return 2.0 * std::atan2(numerator, denominator) / FourPi;
}

WindingNumber::WindingNumber(const std::vector<Triangle>& triangles, const Execution& execution)
  : Triangles(triangles)
{
  if (triangles.empty())
  {
    return;
  }
  const std::vector<Range> ranges = this->splitTop();
  execution.report(0.1);
  std::vector<std::vector<Node>> subtrees(ranges.size());
  execution.phase(0.1, 0.8).forRangeReporting(static_cast<std::int64_t>(ranges.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n)
      {
        this->addNode(ranges[n], subtrees[n]);
      }
    });
  std::vector<Index> top;
  auto next = subtrees.cbegin();
  this->addTop({ 0, static_cast<Index>(this->Triangles.size()) }, this->topLevels(), next, top);
  execution.phase(0.8, 1.0).forRangeReporting(static_cast<std::int64_t>(top.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n)
      {
        this->fillMoments(this->Nodes[static_cast<std::size_t>(top[n])]);
      }
    });
}

int WindingNumber::topLevels() const
{
  constexpr int Most = 5; // up to 32 parts that are built side by side
  constexpr std::size_t WorthATask = 4096;
  int levels = 0;
  while (levels < Most && this->Triangles.size() >> levels > WorthATask)
  {
    ++levels;
  }
  return levels;
}

std::vector<WindingNumber::Range> WindingNumber::splitTop()
{
  std::vector<Range> ranges{ { 0, static_cast<Index>(this->Triangles.size()) } };
  for (int level = this->topLevels(); level > 0; --level)
  {
    std::vector<Range> halves;
    for (const Range& range : ranges)
    {
      splitAtMedian(this->Triangles, range.begin, range.middle(), range.end);
      halves.push_back({ range.begin, range.middle() });
      halves.push_back({ range.middle(), range.end });
    }
    ranges = std::move(halves);
  }
  return ranges;
}

Index WindingNumber::addTop(const Range& range, int levels,
  std::vector<std::vector<Node>>::const_iterator& subtree, std::vector<Index>& top)
{
  const auto number = static_cast<Index>(this->Nodes.size());
  if (levels == 0)
  {
    for (Node node : *subtree)
    {
      node.right += node.right != NoIndex ? number : 0;
      this->Nodes.push_back(node);
    }
    ++subtree;
    return number;
  }
  this->Nodes.emplace_back();
  this->Nodes.back().begin = range.begin;
  this->Nodes.back().end = range.end;
  top.push_back(number);
  this->addTop({ range.begin, range.middle() }, levels - 1, subtree, top);
  const Index right = this->addTop({ range.middle(), range.end }, levels - 1, subtree, top);
  this->Nodes[static_cast<std::size_t>(number)].right = right;
  return number;
}

Index WindingNumber::addNode(const Range& range, std::vector<Node>& nodes)
{
  constexpr Index LargestLeaf = 8;
  const auto number = static_cast<Index>(nodes.size());
  nodes.emplace_back();
  Node node;
  node.begin = range.begin;
  node.end = range.end;
  if (range.end - range.begin > LargestLeaf)
  {
    splitAtMedian(this->Triangles, range.begin, range.middle(), range.end);
    this->addNode({ range.begin, range.middle() }, nodes);
    node.right = this->addNode({ range.middle(), range.end }, nodes);
  }
  this->fillMoments(node);
  nodes[static_cast<std::size_t>(number)] = node;
  return number;
}

void WindingNumber::fillMoments(Node& node) const
{
  const auto first = this->Triangles.begin() + node.begin;
  const auto last = this->Triangles.begin() + node.end;
  Vec3 weighted = Vec3::Zero();
  Vec3 plain = Vec3::Zero();
  double total = 0.0;
  for (auto triangle = first; triangle != last; ++triangle)
  {
    const double area = 0.5 * triangle->doubleAreaNormal().norm();
    weighted += area * triangle->centroid();
    plain += triangle->centroid();
    total += area;
  }
  node.center = total > 0.0 ? Vec3(weighted / total) : Vec3(plain / (node.end - node.begin));
  node.second.fill(Matrix::Zero());
  double squaredRadius = 0.0;
  for (auto triangle = first; triangle != last; ++triangle)
  {
    const Vec3 area = 0.5 * triangle->doubleAreaNormal();
    const Vec3 middle = triangle->centroid() - node.center;
    Matrix products = 9.0 * middle * middle.transpose();
    for (const Vec3& corner : triangle->corners)
    {
      const Vec3 relative = corner - node.center;
      products += relative * relative.transpose();
      squaredRadius = std::max(squaredRadius, relative.squaredNorm());
    }
    node.area += area;
    node.first += middle * area.transpose();
    for (int k = 0; k < 3; ++k)
    {
      node.second[static_cast<std::size_t>(k)] += area[k] / 24.0 * products;
    }
  }
  for (int k = 0; k < 3; ++k)
  {
    const Matrix& second = node.second[static_cast<std::size_t>(k)];
    node.secondTrace += 2.0 * second.col(k) + second.trace() * Vec3::Unit(k);
  }
  node.squaredReach = Accuracy * Accuracy * squaredRadius;
}

double WindingNumber::expansion(const Node& node, const Vec3& r, double squaredDistance)
{
  const double inverseSquare = 1.0 / squaredDistance;
  const double inverseCube = inverseSquare / std::sqrt(squaredDistance);
  double cubic = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    cubic += r[k] * r.dot(node.second[static_cast<std::size_t>(k)] * r);
  }
  // a.grad G + (x a^T):Hess G + 1/2 (x x^T a):D^3 G with grad G = r / (4 pi |r|^3)
  const double zeroth = r.dot(node.area);
  const double first = node.first.trace() - 3.0 * inverseSquare * r.dot(node.first * r);
  const double second =
    3.0 * inverseSquare * (5.0 * inverseSquare * cubic - r.dot(node.secondTrace));
  return (zeroth + first + second) * inverseCube / FourPi;
}

double WindingNumber::at(const Vec3& point) const
{
  constexpr std::size_t DeepestTree = 40; // halves of 2^31 triangles
  std::array<Index, DeepestTree> stack;
  std::size_t size = 0;
  double sum = 0.0;
  if (!this->Nodes.empty())
  {
    stack[size++] = 0;
  }
  while (size > 0)
  {
    const Index number = stack[--size];
    const Node& node = this->Nodes[static_cast<std::size_t>(number)];
    const Vec3 toCenter = node.center - point;
    const double squaredDistance = toCenter.squaredNorm();
    if (squaredDistance > node.squaredReach)
    {
      sum += expansion(node, toCenter, squaredDistance);
    }
    else if (node.right != NoIndex)
    {
      stack[size++] = node.right;
      stack[size++] = number + 1;
    }
    else
    {
      for (Index i = node.begin; i < node.end; ++i)
      {
        sum += windingNumber(this->Triangles[static_cast<std::size_t>(i)], point);
      }
    }
  }
  return sum;
}

} // namespace evolving
