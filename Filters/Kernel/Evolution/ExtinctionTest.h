// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Does a surface shrink to a point in the next step?
 */

#ifndef EVOLVING_EXTINCTION_TEST_H
#define EVOLVING_EXTINCTION_TEST_H

#include "Evolution/FlowOptions.h"
#include "Evolution/FlowState.h"
#include "Mesh/SurfaceMesh.h"
#include "Redistribution/StateArrays.h"

namespace evolving
{

/**
 * Knows it beforehand for a closed surface that mean curvature alone moves, from its
 * expectedLife(). The scheme's own last steps would only draw it together to a speck or a thread,
 * without a time of its own: a backward Euler step leaves something of everything.
 */
class ExtinctionTest
{
public:
  /// @param options in absolute units, with a time step
  ExtinctionTest(const SurfaceMesh& start, bool hasField, const FlowOptions& options);

  /// Looks at the start: where its volume says nothing, only longestLife() is believed.
  void begin(const FlowRecord& record, const StateArrays& arrays);
  /// The time that is left; infinite where nobody knows.
  double timeLeft(const FlowRecord& record, const StateArrays& arrays) const;
  bool isLastBefore(const FlowRecord& record, const StateArrays& arrays) const
  {
    return this->timeLeft(record, arrays) <= this->TimeStep;
  }

  /// Is so little left that a step which fails only says that the rest is gone, too? Also of a
  /// surface with a boundary, which may be a pinprick.
  bool isNearlyGone(const FlowRecord& record) const;

private:
  bool IsFree;           ///< of a field and of held volumes: all it does is shrink
  double CurvatureSpeed; ///< 0: nobody knows
  double TimeStep;
  double StartArea = 0.0;
  bool BelievesVolume = true;
};

} // namespace evolving

#endif
