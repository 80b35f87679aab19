// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Does a surface still get nearer to its target?
 */

#ifndef EVOLVING_STALL_TEST_H
#define EVOLVING_STALL_TEST_H

#include <limits>

namespace evolving
{

/// A farthest distance that falls by less than this part is as good as constant.
constexpr double SmallestGain = 0.01;

/// Remembers the last iteration that brought a surface nearer to its target.
class StallTest
{
public:
  /**
   * Looks at a state; iterations must increase.
   * @param farthest distance of the surface from its target
   * @return true when it has not fallen by more than SmallestGain for that many steps
   */
  bool hasStalled(int iteration, double farthest, int steps)
  {
    if (farthest < (1.0 - SmallestGain) * this->Farthest)
    {
      this->Farthest = farthest;
      this->LastGain = iteration;
    }
    return iteration - this->LastGain >= steps;
  }

private:
  double Farthest = std::numeric_limits<double>::infinity(); ///< at the last gain
  int LastGain = 0;
};

} // namespace evolving

#endif
