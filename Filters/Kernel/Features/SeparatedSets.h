// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Items joined into sets of which some must stay apart.
 */

#ifndef EVOLVING_SEPARATED_SETS_H
#define EVOLVING_SEPARATED_SETS_H

#include "Mesh/DisjointSets.h"
#include "Types.h"

#include <set>
#include <unordered_map>

namespace evolving
{

/// Union-find in which pairs of sets refuse to be joined.
class SeparatedSets
{
public:
  explicit SeparatedSets(std::size_t count)
    : Sets(count)
  {
  }

  Index find(Index i) { return this->Sets.find(i); }
  /// The sets of i and j must stay apart from now on; they are different ones.
  void separate(Index i, Index j)
  {
    this->Apart[this->find(i)].insert(this->find(j));
    this->Apart[this->find(j)].insert(this->find(i));
  }
  bool areSeparate(Index i, Index j)
  {
    const auto found = this->Apart.find(this->find(i));
    return found != this->Apart.end() && found->second.count(this->find(j)) > 0;
  }
  /// @return whether i and j are in one set now; not when these must stay apart
  bool join(Index i, Index j)
  {
    const Index a = this->find(i);
    const Index b = this->find(j);
    if (a == b || this->areSeparate(a, b))
    {
      return a == b;
    }
    this->Sets.join(a, b);
    const Index root = this->find(a);
    this->moveSeparations(root == a ? b : a, root);
    return true;
  }

private:
  void moveSeparations(Index from, Index to)
  {
    const auto found = this->Apart.find(from);
    if (found == this->Apart.end())
    {
      return;
    }
    const std::set<Index> others = std::move(found->second);
    this->Apart.erase(found);
    for (const Index other : others)
    {
      this->Apart[other].erase(from);
      this->Apart[other].insert(to);
      this->Apart[to].insert(other);
    }
  }

  DisjointSets Sets;
  std::unordered_map<Index, std::set<Index>> Apart; ///< by root, roots; never iterated over
};

} // namespace evolving

#endif
