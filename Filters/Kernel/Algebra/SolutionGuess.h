// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Warm starts for systems that change little from one step to the next.
 */

#ifndef EVOLVING_SOLUTION_GUESS_H
#define EVOLVING_SOLUTION_GUESS_H

#include "Execution.h"
#include "ParallelLoops.h"

#include <utility>
#include <vector>

namespace evolving
{

/**
 * Goes on by the parabola through the last three solutions, by the line through two, or with the
 * only one. Steps of unequal length or a solve that failed give a bad guess, no more.
 */
template <class Value>
class SolutionGuess
{
public:
  /// @param[in,out] x the last solution, of the same size in every call, then the guess
  void extrapolate(std::vector<Value>& x, const Execution& execution)
  {
    const int known = this->Known;
    this->Known = known < 3 ? known + 1 : 3;
    if (known == 0)
    {
      return; // what is in x was not solved for
    }
    this->Last.resize(x.size());
    this->Older.resize(x.size());
    std::swap(this->Last, this->Older);
    forEachIndex(execution, static_cast<std::int64_t>(x.size()),
      [&](Index i)
      {
        const Value now = x[at(i)];
        const Value before = this->Older[at(i)];
        const Value oldest = this->Last[at(i)]; // to be overwritten
        if (known == 2)
        {
          x[at(i)] = 2.0 * now - before;
        }
        else if (known == 3)
        {
          x[at(i)] = 3.0 * (now - before) + oldest;
        }
        this->Last[at(i)] = now;
      });
  }

private:
  int Known = 0; ///< solutions so far, at most 3
  std::vector<Value> Last;
  std::vector<Value> Older;
};

} // namespace evolving

#endif
