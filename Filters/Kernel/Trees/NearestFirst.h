// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The way through a tree of boxes, from those near to a point to those farther away.
 */

#ifndef EVOLVING_NEAREST_FIRST_H
#define EVOLVING_NEAREST_FIRST_H

#include "Types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace evolving
{

/**
 * Calls bound = visit(triangle) for those in boxes that are no farther away than the bound is then.
 * @tparam MostPending children that wait at most
 * @param nodes the root first, or none: each with `children`, the number of a node or ~that of a
 *   triangle, and `childCount`
 * @param bound a squared distance
 * @param gapsOf a node: the squared distances of its children's boxes
 */
template <std::size_t MostPending, typename Gap, typename Node, typename GapsOf, typename Visit>
void visitNearestFirst(
  const std::vector<Node>& nodes, Gap bound, const GapsOf& gapsOf, const Visit& visit)
{
  struct Pending
  {
    Index child;
    Gap squaredGap;
  };
  std::array<Pending, MostPending> stack; // queries allocate nothing
  std::size_t size = 0;
  if (!nodes.empty())
  {
    stack[size++] = { 0, Gap(0) };
  }
  while (size > 0)
  {
    const Pending next = stack[--size];
    if (next.squaredGap > bound)
    {
      continue;
    }
    if (next.child < 0)
    {
      bound = visit(~next.child);
      continue;
    }
    const Node& node = nodes[static_cast<std::size_t>(next.child)];
    const auto gaps = gapsOf(node);
    const std::size_t first = size;
    for (int k = 0; k < node.childCount; ++k)
    {
      if (gaps[k] <= bound)
      {
        std::size_t place = size++;
        for (; place > first && stack[place - 1].squaredGap < gaps[k]; --place)
        {
          stack[place] = stack[place - 1];
        }
        stack[place] = { node.children[static_cast<std::size_t>(k)], gaps[k] };
      }
    }
  }
}

} // namespace evolving

#endif
