// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "StartSurface/LeastAreaCap.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

constexpr double Forbidden = std::numeric_limits<double>::infinity();

/// A triangle's area, and more for a sliver: times 1 + 1/(1000 q^2), where q is 1 for an
/// equilateral one (twice the root of 12 times the area by the sum of the squared sides).
double shapedArea(const Vec3& a, const Vec3& b, const Vec3& c)
{
  constexpr double SliverPenalty = 1e-3;
  constexpr double LeastRatio = 1e-12; // keeps the penalty of a triangle without area finite
  const double area = 0.5 * (b - a).cross(c - a).norm();
  const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  const double floored = std::max(area, LeastRatio * sides);
  return floored > 0.0 ? area + SliverPenalty / 48.0 * sides * sides / floored : 0.0;
}

/// Best triangulations of the polygons that a diagonal cuts off, from short runs to long ones.
class LeastAreaTable
{
public:
  explicit LeastAreaTable(const std::vector<Vec3>& corners)
    : Corners(corners)
    , Best(corners.size() * corners.size(), 0.0)
    , Middle(corners.size() * corners.size(), NoIndex)
  {
  }

  void fill(const DiagonalPredicate& isAllowed)
  {
    const std::size_t n = this->Corners.size();
    for (std::size_t span = 2; span < n; ++span)
    {
      for (std::size_t first = 0; first + span < n; ++first)
      {
        const bool isDiagonal = span + 1 < n;
        const std::size_t last = first + span;
        if (isDiagonal && !isAllowed(static_cast<Index>(first), static_cast<Index>(last)))
        {
          this->Best[this->entry(first, last)] = Forbidden;
        }
        else
        {
          this->fillEntry(first, last);
        }
      }
    }
  }

  std::vector<std::array<Index, 3>> triangles() const
  {
    std::vector<std::array<Index, 3>> result;
    std::vector<std::pair<std::size_t, std::size_t>> runs{ { 0, this->Corners.size() - 1 } };
    while (!runs.empty())
    {
      const auto [first, last] = runs.back();
      runs.pop_back();
      const Index middle = this->Middle[this->entry(first, last)];
      if (middle != NoIndex)
      {
        result.push_back({ static_cast<Index>(first), middle, static_cast<Index>(last) });
        runs.emplace_back(at(middle), last);
        runs.emplace_back(first, at(middle));
      }
    }
    return result;
  }

private:
  std::size_t entry(std::size_t first, std::size_t last) const
  {
    return first * this->Corners.size() + last;
  }

  void fillEntry(std::size_t first, std::size_t last)
  {
    double best = Forbidden;
    Index bestMiddle = NoIndex;
    for (std::size_t middle = first + 1; middle < last; ++middle)
    {
      const double parts =
        this->Best[this->entry(first, middle)] + this->Best[this->entry(middle, last)];
      if (parts < best)
      {
        const double sum =
          parts + shapedArea(this->Corners[first], this->Corners[middle], this->Corners[last]);
        bestMiddle = sum < best ? static_cast<Index>(middle) : bestMiddle;
        best = std::min(best, sum);
      }
    }
    this->Best[this->entry(first, last)] = best;
    this->Middle[this->entry(first, last)] = bestMiddle;
  }

  const std::vector<Vec3>& Corners;
  std::vector<double> Best;  ///< weight of the polygon first ... last
  std::vector<Index> Middle; ///< third corner of its triangle at the diagonal
};

} // namespace

std::vector<std::array<Index, 3>> leastAreaCap(
  const std::vector<Vec3>& corners, const DiagonalPredicate& isAllowed)
{
  if (corners.size() < 3)
  {
    return {};
  }
  LeastAreaTable table(corners);
  table.fill(isAllowed);
  return table.triangles();
}

} // namespace evolving
