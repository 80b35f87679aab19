// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Loops over vertices, faces and matrix rows, index by index, on an Execution.
 */

#ifndef EVOLVING_PARALLEL_LOOPS_H
#define EVOLVING_PARALLEL_LOOPS_H

#include "Execution.h"
#include "Types.h"

#include <cstdint>

namespace evolving
{

/// Indices per chunk. Starting a parallel loop costs tens of microseconds in the hosts, as much
/// as a few thousand rows of a matrix product: smaller meshes are quicker on one thread.
constexpr std::int64_t LoopGrain = 4096;

/// Calls body(i) for all i in [0, count).
template <class Body>
void forEachIndex(const Execution& execution, std::int64_t count, const Body& body)
{
  execution.forRange(count, LoopGrain,
    [&body](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        body(static_cast<Index>(i));
      }
    });
}

/// The sum of term(i) over [0, count), the same bits for any number of threads.
template <class Term>
double sumEachIndex(const Execution& execution, std::int64_t count, const Term& term)
{
  return execution.sumRange(count, LoopGrain,
    [&term](std::int64_t begin, std::int64_t end)
    {
      double sum = 0.0;
      for (std::int64_t i = begin; i < end; ++i)
      {
        sum += term(static_cast<Index>(i));
      }
      return sum;
    });
}

} // namespace evolving

#endif
