// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/ClosestPoint/OrientedBoxTree.h"

#include "Trees/OrientedBox.h"

#include <algorithm>
#include <array>

namespace evolving
{

namespace
{

/// A triangle on its way to its place.
struct Reference
{
  std::array<float, 3> centroid;
  Index triangle;
};

/// References [begin, end).
struct Range
{
  Index begin = 0;
  Index end = 0;

  Index size() const { return this->end - this->begin; }
};

/// Cuts a range into two of about equal number; the first fills whole leaves.
std::array<Range, 2> halves(std::vector<Reference>& references, const Range& range)
{
  Eigen::AlignedBox3f box;
  for (Index i = range.begin; i < range.end; ++i)
  {
    box.extend(
      Eigen::Map<const Eigen::Vector3f>(references[static_cast<std::size_t>(i)].centroid.data()));
  }
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const auto a = static_cast<std::size_t>(axis);
  const Index leaves = (range.size() / 2 + BoxFan::Width - 1) / BoxFan::Width;
  const Index middle = range.begin + leaves * BoxFan::Width;
  std::nth_element(references.begin() + range.begin, references.begin() + middle,
    references.begin() + range.end,
    [a](const Reference& p, const Reference& q)
    {
      return p.centroid[a] != q.centroid[a] ? p.centroid[a] < q.centroid[a]
                                            : p.triangle < q.triangle;
    });
  return { Range{ range.begin, middle }, Range{ middle, range.end } };
}

/// The parts of a range for the boxes of a fan: halves of halves of halves, where large enough.
std::vector<Range> partsOf(std::vector<Reference>& references, const Range& range)
{
  std::vector<Range> parts{ range };
  for (int round = 0; round < 3; ++round)
  {
    std::vector<Range> finer;
    for (const Range& part : parts)
    {
      if (part.size() <= BoxFan::Width)
      {
        finer.push_back(part);
        continue;
      }
      const auto two = halves(references, part);
      finer.insert(finer.end(), two.begin(), two.end());
    }
    parts = std::move(finer);
  }
  return parts;
}

class Builder
{
public:
  Builder(const std::vector<Triangle>& triangles, double margin)
    : Triangles(triangles)
    , Margin(margin)
    , References(triangles.size())
  {
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      const auto& corners = triangles[i].corners;
      const Eigen::Vector3f middle = ((corners[0] + corners[1] + corners[2]) / 3.0).cast<float>();
      this->References[i] = { { middle.x(), middle.y(), middle.z() }, static_cast<Index>(i) };
    }
  }

  /// The root's parts are built side by side and then put one after the other.
  std::vector<BoxFan> build(const Execution& execution)
  {
    const Range all{ 0, static_cast<Index>(this->References.size()) };
    if (all.size() <= BoxFan::Width)
    {
      return { this->leaf(all) };
    }
    const std::vector<Range> parts = partsOf(this->References, all);
    execution.report(0.1);
    std::vector<std::vector<BoxFan>> subtrees(parts.size());
    std::vector<BoxFan> fans(1);
    execution.phase(0.1, 1.0).forRangeReporting(static_cast<std::int64_t>(parts.size()), 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (auto p = static_cast<std::size_t>(begin); p < static_cast<std::size_t>(end); ++p)
        {
          constexpr std::size_t TrianglesAFan = 5; // a few less than in practice
          subtrees[p].reserve(static_cast<std::size_t>(parts[p].size()) / TrianglesAFan + 1);
          this->addFan(parts[p], subtrees[p]);
          this->fitBox(fans[0], static_cast<int>(p), parts[p]);
        }
      });
    fans[0].count = static_cast<int>(parts.size());
    std::size_t count = 1;
    for (const std::vector<BoxFan>& subtree : subtrees)
    {
      count += subtree.size();
    }
    fans.reserve(count);
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      fans[0].child[p] = static_cast<Index>(fans.size());
      append(fans, subtrees[p]);
      std::vector<BoxFan>().swap(subtrees[p]); // both at once would be the peak of the whole method
    }
    return fans;
  }

  const std::vector<Reference>& references() const { return this->References; }

private:
  /// @return the fan's number in the list
  Index addFan(const Range& range, std::vector<BoxFan>& fans)
  {
    const auto number = static_cast<Index>(fans.size());
    if (range.size() <= BoxFan::Width)
    {
      fans.push_back(this->leaf(range));
      return number;
    }
    fans.emplace_back();
    const std::vector<Range> parts = partsOf(this->References, range);
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      this->fitBox(fans[static_cast<std::size_t>(number)], static_cast<int>(p), parts[p]);
      const Index child = this->addFan(parts[p], fans);
      fans[static_cast<std::size_t>(number)].child[p] = child;
    }
    fans[static_cast<std::size_t>(number)].count = static_cast<int>(parts.size());
    return number;
  }

  BoxFan leaf(const Range& range) const
  {
    BoxFan fan;
    fan.isLeaf = true;
    fan.count = static_cast<int>(range.size());
    for (int k = 0; k < fan.count; ++k)
    {
      this->fitBox(fan, k, { range.begin + k, range.begin + k + 1 });
      fan.child[k] = range.begin + k;
    }
    return fan;
  }

  void fitBox(BoxFan& fan, int place, const Range& range) const
  {
    std::vector<const Triangle*> group;
    group.reserve(static_cast<std::size_t>(range.size()));
    for (Index i = range.begin; i < range.end; ++i)
    {
      const Reference& reference = this->References[static_cast<std::size_t>(i)];
      group.push_back(&this->Triangles[static_cast<std::size_t>(reference.triangle)]);
    }
    storeBox(orientedBoxAround(group), this->Margin, place, fan);
  }

  static void storeBox(const OrientedBox& box, double margin, int place, BoxFan& fan)
  {
    for (int k = 0; k < 3; ++k)
    {
      fan.center[k][place] = static_cast<float>(box.center[k]);
      fan.halfSize[k][place] = static_cast<float>(box.halfSize[k] + margin);
      for (int axis = 0; axis < 3; ++axis)
      {
        fan.axis[k][axis][place] = static_cast<float>(box.axes(axis, k));
      }
    }
    fan.longestSide[place] = static_cast<float>(2.0 * box.halfSize.maxCoeff());
  }

  static void append(std::vector<BoxFan>& fans, const std::vector<BoxFan>& subtree)
  {
    const auto offset = static_cast<Index>(fans.size());
    for (BoxFan fan : subtree)
    {
      for (int k = 0; !fan.isLeaf && k < fan.count; ++k)
      {
        fan.child[k] += offset;
      }
      fans.push_back(fan);
    }
  }

  const std::vector<Triangle>& Triangles;
  double Margin;
  std::vector<Reference> References;
};

} // namespace

OrientedBoxTree::OrientedBoxTree(
  const std::vector<Triangle>& triangles, double margin, const Execution& execution)
{
  if (triangles.empty())
  {
    return;
  }
  Builder builder(triangles, margin);
  this->Fans = builder.build(execution.phase(0.0, 0.8));
  this->Framed.resize(triangles.size());
  execution.phase(0.8, 1.0).forRangeReporting(static_cast<std::int64_t>(triangles.size()),
    Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const Index number = builder.references()[i].triangle;
        this->Framed[i] = FramedTriangle(triangles[static_cast<std::size_t>(number)], number);
      }
    });
}

} // namespace evolving
