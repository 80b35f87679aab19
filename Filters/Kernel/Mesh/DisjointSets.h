// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which items belong together, found by joining pairs.
 */

#ifndef EVOLVING_DISJOINT_SETS_H
#define EVOLVING_DISJOINT_SETS_H

#include "Types.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace evolving
{

/// Union-find with path halving (Tarjan, van Leeuwen 1984); roots are the smallest members.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  /// The smallest member of the set that i belongs to.
  Index find(Index i)
  {
    while (this->parent(i) != i)
    {
      this->parent(i) = this->parent(this->parent(i));
      i = this->parent(i);
    }
    return i;
  }
  void join(Index i, Index j)
  {
    i = this->find(i);
    j = this->find(j);
    this->parent(std::max(i, j)) = std::min(i, j);
  }

private:
  Index& parent(Index i) { return this->Parent[static_cast<std::size_t>(i)]; }

  std::vector<Index> Parent;
};

} // namespace evolving

#endif
