// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/ChartMerging.h"

#include "Features/ChartBorders.h"

#include <algorithm>
#include <utility>

namespace evolving
{

namespace
{

using NamePair = std::pair<Index, Index>;

/// The borders after some charts were merged.
BorderLengths renamed(const BorderLengths& borders, SeparatedSets& charts)
{
  BorderLengths result;
  for (const auto& [pair, length] : borders)
  {
    const NamePair names = std::minmax({ charts.find(pair.first), charts.find(pair.second) });
    if (names.first != names.second)
    {
      result[names] += length;
    }
  }
  return result;
}

/// The border whose charts are to be merged next; the end when there is none.
BorderLengths::const_iterator longestMergeable(const BorderLengths& borders, SeparatedSets& charts)
{
  auto longest = borders.end();
  for (auto border = borders.begin(); border != borders.end(); ++border)
  {
    if ((longest == borders.end() || border->second > longest->second) &&
      !charts.areSeparate(border->first.first, border->first.second))
    {
      longest = border;
    }
  }
  return longest;
}

} // namespace

void mergeCharts(const TargetTriangles& target, const SharpEdges& sharp, SeparatedSets& charts,
  std::vector<Index>& names)
{
  BorderLengths borders = artificialBorders(target, sharp, names);
  for (auto next = longestMergeable(borders, charts); next != borders.end();
       next = longestMergeable(borders, charts))
  {
    charts.join(next->first.first, next->first.second);
    borders = renamed(borders, charts);
  }
  for (Index& name : names)
  {
    name = charts.find(name);
  }
}

} // namespace evolving
