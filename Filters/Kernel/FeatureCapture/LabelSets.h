// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Small sets of labels of a target, as ascending lists.
 */

#ifndef EVOLVING_LABEL_SETS_H
#define EVOLVING_LABEL_SETS_H

#include "Types.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace evolving
{

/// Ascending, each once.
using Labels = std::vector<Index>;

inline Labels labelSet(std::vector<Index> labels)
{
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return labels;
}

inline bool contains(const Labels& labels, Index label)
{
  return std::binary_search(labels.begin(), labels.end(), label);
}

inline Labels inBoth(const Labels& a, const Labels& b)
{
  Labels both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

inline Labels inEither(const Labels& a, const Labels& b)
{
  Labels either;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(either));
  return either;
}

} // namespace evolving

#endif
