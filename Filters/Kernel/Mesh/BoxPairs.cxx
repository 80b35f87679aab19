// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/BoxPairs.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace evolving
{

namespace
{

/**
 * Boxes in an order in which every half of every half of the sequence is compact, with the box
 * around each. A range [begin, end) longer than a leaf splits at its middle, which belongs to no
 * other range, so that its box is stored under that number and the tree needs no links.
 */
class HalvedBoxes
{
public:
  HalvedBoxes(const std::vector<Box>& boxes, const Execution& execution)
    : Boxes(boxes)
    , RangeBoxes(boxes.size())
  {
    for (Index i = 0; i < static_cast<Index>(boxes.size()); ++i)
    {
      if (!boxes[at(i)].isEmpty())
      {
        this->Order.push_back(i);
      }
    }
    this->build(execution);
    for (const Index i : this->Order)
    {
      this->Ordered.push_back(boxes[at(i)]);
    }
  }

  Index count() const { return static_cast<Index>(this->Order.size()); }
  /// The number that the box at a position of the sequence had.
  Index number(Index position) const { return this->Order[at(position)]; }

  /// Calls visit(other) for each later position whose box overlaps the one at a position.
  template <typename Visit>
  void forEachLaterOverlap(Index position, const Visit& visit) const
  {
    this->search(this->Ordered[at(position)], position + 1, 0, this->count(), visit);
  }

  /// Calls visit(position) for each box that overlaps another one.
  template <typename Visit>
  void forEachOverlap(const Box& box, const Visit& visit) const
  {
    this->search(box, 0, 0, this->count(), visit);
  }

private:
  static constexpr Index LeafSize = 4;

  static Index middle(Index begin, Index end) { return begin + (end - begin) / 2; }

  using Range = std::pair<Index, Index>;

  /// The first halvings level by level, until there are ranges for all threads; none too small.
  void build(const Execution& execution)
  {
    constexpr Index Enough = 32;
    std::vector<Range> ranges{ { 0, this->count() } };
    while (static_cast<Index>(ranges.size()) < std::min(Enough, this->count() / (2 * LeafSize)))
    {
      execution.forRange(static_cast<std::int64_t>(ranges.size()), 1,
        [&](std::int64_t begin, std::int64_t end)
        {
          for (std::int64_t i = begin; i < end; ++i)
          {
            this->divide(ranges[static_cast<std::size_t>(i)]);
          }
        });
      std::vector<Range> halves;
      for (const auto& [begin, end] : ranges)
      {
        halves.emplace_back(begin, middle(begin, end));
        halves.emplace_back(middle(begin, end), end);
      }
      ranges = std::move(halves);
    }
    execution.forRange(static_cast<std::int64_t>(ranges.size()), 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t i = begin; i < end; ++i)
        {
          this->buildBelow(ranges[static_cast<std::size_t>(i)]);
        }
      });
  }

  void buildBelow(const Range& range)
  {
    this->divide(range);
    const auto& [begin, end] = range;
    if (end - begin > LeafSize)
    {
      this->buildBelow({ begin, middle(begin, end) });
      this->buildBelow({ middle(begin, end), end });
    }
  }

  /// Finds the range's box, and sorts it into halves.
  void divide(const Range& range)
  {
    const auto& [begin, end] = range;
    Box box;
    Box centers;
    for (Index position = begin; position < end; ++position)
    {
      const Box& next = this->Boxes[at(this->Order[at(position)])];
      box.extend(next);
      centers.extend(next.center());
    }
    const Index half = middle(begin, end);
    if (end > begin)
    {
      this->RangeBoxes[at(half)] = box;
    }
    if (end - begin > LeafSize)
    {
      Eigen::Index axis = 0;
      centers.sizes().maxCoeff(&axis);
      const auto center = [&](Index i)
      { return this->Boxes[at(i)].min()[axis] + this->Boxes[at(i)].max()[axis]; };
      std::nth_element(this->Order.begin() + begin, this->Order.begin() + half,
        this->Order.begin() + end, [&](Index i, Index j) { return center(i) < center(j); });
    }
  }

  /// From a position on.
  template <typename Visit>
  void search(const Box& box, Index from, Index begin, Index end, const Visit& visit) const
  {
    const Index half = middle(begin, end);
    if (end <= from || begin == end || !this->RangeBoxes[at(half)].intersects(box))
    {
      return;
    }
    if (end - begin > LeafSize)
    {
      this->search(box, from, begin, half, visit);
      this->search(box, from, half, end, visit);
      return;
    }
    for (Index other = std::max(begin, from); other < end; ++other)
    {
      if (this->Ordered[at(other)].intersects(box))
      {
        visit(other);
      }
    }
  }

  const std::vector<Box>& Boxes;
  std::vector<Index> Order;
  std::vector<Box> Ordered;
  std::vector<Box> RangeBoxes;
};

} // namespace

std::vector<IndexPair> overlappingPairs(
  const std::vector<Box>& boxes, const PairPredicate& isWanted, const Execution& execution)
{
  constexpr std::int64_t Grain = 128;
  const HalvedBoxes halved(boxes, execution);
  std::vector<std::vector<IndexPair>> found(at(halved.count()) / Grain + 1);
  execution.forRangeReporting(halved.count(), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<IndexPair>& pairs = found[static_cast<std::size_t>(begin / Grain)];
      for (auto position = static_cast<Index>(begin); position < static_cast<Index>(end);
           ++position)
      {
        halved.forEachLaterOverlap(position,
          [&](Index other)
          {
            const IndexPair pair = std::minmax({ halved.number(position), halved.number(other) });
            if (isWanted(pair.first, pair.second))
            {
              pairs.push_back(pair);
            }
          });
      }
    });
  std::vector<IndexPair> all;
  for (const std::vector<IndexPair>& pairs : found)
  {
    all.insert(all.end(), pairs.begin(), pairs.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<std::vector<Index>> boxesOverlapping(
  const std::vector<Box>& few, const std::vector<Box>& others, const Execution& execution)
{
  constexpr std::int64_t Grain = 4096;
  const HalvedBoxes halved(few, execution);
  std::vector<std::vector<IndexPair>> found(others.size() / Grain + 1);
  execution.forRangeReporting(static_cast<std::int64_t>(others.size()), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<IndexPair>& pairs = found[static_cast<std::size_t>(begin / Grain)];
      for (auto other = static_cast<Index>(begin); other < static_cast<Index>(end); ++other)
      {
        halved.forEachOverlap(others[at(other)],
          [&](Index position) { pairs.emplace_back(halved.number(position), other); });
      }
    });
  std::vector<std::vector<Index>> overlapping(few.size());
  for (const std::vector<IndexPair>& pairs : found)
  {
    for (const auto& [box, other] : pairs)
    {
      overlapping[at(box)].push_back(other);
    }
  }
  return overlapping;
}

} // namespace evolving
