// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/SignedDistanceOptions.h"

namespace evolving
{

int peakBytesPerSample(const SignedDistanceOptions& options)
{
  constexpr int Side = 1;
  constexpr int Number = 4;               // a float or a triangle
  int bytes = 2 * Number + Side + Number; // distance, triangle, side, the copy
  bytes += options.method == DistanceMethod::FastSweeping ? 3 * Number + Side : 0;
  bytes += options.sign == SignMethod::FloodFill ? 2 * Number : 0; // the samples still to visit
  bytes += options.smoothingSigma > 0.0 ? Number : 0;
  bytes += options.closestFace ? 4 * Number : 0; // copied as a number of 64 bits
  bytes += options.closestPoint ? 6 * Number : 0;
  bytes += options.gradient ? 6 * Number : 0;
  return bytes;
}

bool canComputeParts(const SignedDistanceOptions& options)
{
  return options.method != DistanceMethod::FastSweeping && options.sign != SignMethod::FloodFill;
}

} // namespace evolving
