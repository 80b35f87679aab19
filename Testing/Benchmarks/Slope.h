// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Orders of convergence and growth: straight lines through measurements.
 */

#ifndef BENCHMARK_SLOPE_H
#define BENCHMARK_SLOPE_H

#include <cmath>
#include <cstddef>
#include <vector>

namespace benchmark
{

struct Line
{
  double start = 0.0; ///< at x = 0
  double slope = 0.0;
};

/// The line with the least sum of squares; needs two different x.
inline Line lineThrough(const std::vector<double>& x, const std::vector<double>& y)
{
  double meanX = 0.0;
  double meanY = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    meanX += x[i] / static_cast<double>(x.size());
    meanY += y[i] / static_cast<double>(x.size());
  }
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    products += (x[i] - meanX) * (y[i] - meanY);
    squares += (x[i] - meanX) * (x[i] - meanX);
  }
  const double slope = products / squares;
  return { meanY - slope * meanX, slope };
}

/// The exponent p of y = c x^p.
inline double exponentOf(std::vector<double> x, std::vector<double> y)
{
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    x[i] = std::log(x[i]);
    y[i] = std::log(y[i]);
  }
  return lineThrough(x, y).slope;
}

} // namespace benchmark

#endif
