// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ExtinctionTest.h"

#include "Evolution/CurvatureLife.h"
#include "Mesh/TopologySummary.h"

#include <cstddef>
#include <limits>

namespace evolving
{

namespace
{

/// A start that is to be gone in fewer steps is none whose volume says how long it lives: of a
/// plate expectedLife() is half of what it should be.
constexpr double TrustedSteps = 2.0;
/// Of the area of the start: a ball that has so much left would have it for a thousandth of its
/// life.
constexpr double NearlyGone = 1e-3;

} // namespace

ExtinctionTest::ExtinctionTest(const SurfaceMesh& start, bool hasField, const FlowOptions& options)
  : IsFree(!hasField && !options.holdsVolume())
  , CurvatureSpeed(
      this->IsFree && summarizeTopology(start).isClosed() ? options.curvatureSpeed : 0.0)
  , TimeStep(options.timeStep)
{
}

void ExtinctionTest::begin(const FlowRecord& record, const StateArrays& arrays)
{
  this->StartArea = record.area;
  // Sheets with two sides at one place have no volume, and live on.
  this->BelievesVolume = this->timeLeft(record, arrays) > TrustedSteps * this->TimeStep;
}

double ExtinctionTest::timeLeft(const FlowRecord& record, const StateArrays& arrays) const
{
  if (this->CurvatureSpeed == 0.0)
  {
    return std::numeric_limits<double>::infinity();
  }
  double curvature = 0.0;
  for (std::size_t i = 0; i < arrays.meanCurvature.size(); ++i)
  {
    curvature += arrays.meanCurvature[i] * arrays.coVolume[i];
  }
  const double life = this->BelievesVolume ? expectedLife(record.area, record.volume, curvature)
                                           : longestLife(record.area);
  return life / this->CurvatureSpeed;
}

bool ExtinctionTest::isNearlyGone(const FlowRecord& record) const
{
  return this->IsFree && record.area < NearlyGone * this->StartArea;
}

} // namespace evolving
