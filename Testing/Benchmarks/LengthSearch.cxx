// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LengthSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace benchmark
{

namespace
{

/// The longest length that makes too many vertices and the shortest that makes too few.
struct Bracket
{
  double tooMany = 0.0;
  double tooFew = std::numeric_limits<double>::infinity();

  void add(double length, double ratio)
  {
    if (ratio > 1.0)
    {
      this->tooMany = std::max(this->tooMany, length);
    }
    else
    {
      this->tooFew = std::min(this->tooFew, length);
    }
  }

  /// Twice as long edges make a quarter of the vertices; between two tries, the mean: the number
  /// of vertices jumps where coarse edges are split once more.
  double next(double length, double ratio) const
  {
    constexpr double LongestStride = 4.0;
    return this->tooMany > 0.0 && std::isfinite(this->tooFew)
      ? std::sqrt(this->tooMany * this->tooFew)
      : length * std::clamp(std::sqrt(ratio), 1.0 / LongestStride, LongestStride);
  }
};

} // namespace

double lengthForVertices(
  double vertices, double guess, const std::function<double(double)>& vertexCount)
{
  constexpr int MostTries = 10;
  constexpr double Tolerance = 0.02;
  Bracket bracket;
  double best = guess;
  double leastError = std::numeric_limits<double>::infinity();
  double length = guess;
  for (int tries = 0; tries < MostTries && leastError > Tolerance; ++tries)
  {
    const double ratio = vertexCount(length) / vertices;
    if (std::abs(ratio - 1.0) < leastError)
    {
      leastError = std::abs(ratio - 1.0);
      best = length;
    }
    bracket.add(length, ratio);
    length = bracket.next(length, ratio);
  }
  return best;
}

} // namespace benchmark
