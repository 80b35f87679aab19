// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SignedDistanceChecks.h"

#include "Errors.h"
#include "ParameterRange.h"

#include <sstream>

namespace evolving
{

void requireUsable(const SignedDistanceOptions& options)
{
  constexpr double LargestSigma = 1000.0;
  checkRange("BandWidth", options.bandWidth, 0.0, AnyNumber, "0 means the whole grid");
  checkRange("SmoothingSigma", options.smoothingSigma, 0.0, LargestSigma, "0 means no smoothing");
  checkRange("NumberOfSweeps", options.numberOfSweeps, 0.0, AnyNumber, "8 reach every sample");
}

void requireUsable(const DistanceGrid& grid, const Extent& part)
{
  if (!grid.origin.allFinite() || !grid.spacing.allFinite() || !(grid.spacing.minCoeff() > 0.0) ||
    grid.sampleCount() == 0)
  {
    std::ostringstream message;
    message << "The grid has the origin (" << grid.origin.transpose() << "), the spacing ("
            << grid.spacing.transpose() << ") and " << grid.sampleCount()
            << " samples, expected finite numbers, positive spacing and at least one sample.";
    throw InputError(message.str());
  }
  for (std::size_t e = 0; e < 6; e += 2)
  {
    if (part[e] < grid.extent[e] || part[e + 1] > grid.extent[e + 1] || part[e] > part[e + 1])
    {
      std::ostringstream message;
      message << "The part [" << part[e] << ", " << part[e + 1] << "] along axis " << e / 2
              << " is not in the grid's extent [" << grid.extent[e] << ", " << grid.extent[e + 1]
              << "]; ask for a part of the grid.";
      throw InputError(message.str());
    }
  }
}

} // namespace evolving
