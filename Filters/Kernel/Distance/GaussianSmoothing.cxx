// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/GaussianSmoothing.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// The weights at 0, 1, ..., radius; those at 0 and twice the others sum to 1.
std::vector<double> gaussianWeights(double sigma)
{
  std::vector<double> weights(static_cast<std::size_t>(smoothingRadius(sigma)) + 1);
  double sum = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    const double x = static_cast<double>(k) / sigma;
    weights[k] = std::exp(-0.5 * x * x);
    sum += k == 0 ? weights[k] : 2.0 * weights[k];
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

/// Copies a line of samples and continues it by the radius at both ends.
void continueLine(
  const float* line, GridIndex stride, int count, int radius, std::vector<double>& continued)
{
  continued.resize(static_cast<std::size_t>(count + 2 * radius));
  const auto value = [&](int i) { return static_cast<double>(line[i * stride]); };
  for (int i = 0; i < count; ++i)
  {
    continued[static_cast<std::size_t>(radius + i)] = value(i);
  }
  for (int k = 1; k <= radius; ++k)
  {
    const int mirrored = std::min(k, count - 1);
    continued[static_cast<std::size_t>(radius - k)] = 2.0 * value(0) - value(mirrored);
    continued[static_cast<std::size_t>(radius + count - 1 + k)] =
      2.0 * value(count - 1) - value(count - 1 - mirrored);
  }
}

void smoothLine(float* line, GridIndex stride, int count, const std::vector<double>& weights)
{
  thread_local std::vector<double> continued;
  const int radius = static_cast<int>(weights.size()) - 1;
  continueLine(line, stride, count, radius, continued);
  for (int i = 0; i < count; ++i)
  {
    const double* center = continued.data() + radius + i;
    double sum = weights[0] * center[0];
    for (int k = 1; k <= radius; ++k)
    {
      sum += weights[static_cast<std::size_t>(k)] * (center[-k] + center[k]);
    }
    line[i * stride] = static_cast<float>(sum);
  }
}

} // namespace

int smoothingRadius(double sigma)
{
  return static_cast<int>(std::ceil(3.0 * sigma));
}

void smoothGaussian(std::vector<float>& values, const std::array<int, 3>& dimensions, double sigma,
  const Execution& execution)
{
  if (!(sigma > 0.0))
  {
    return;
  }
  const std::vector<double> weights = gaussianWeights(sigma);
  const auto total = static_cast<GridIndex>(values.size());
  GridIndex stride = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const GridIndex lineStride = stride;
    const GridIndex block = stride * dimensions[axis];
    constexpr std::int64_t LineGrain = 64;
    const Execution phase =
      execution.phase(static_cast<double>(axis) / 3.0, static_cast<double>(axis + 1) / 3.0);
    phase.forRangeReporting(total / dimensions[axis], LineGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t line = begin; line < end; ++line)
        {
          const GridIndex first = line / lineStride * block + line % lineStride;
          smoothLine(values.data() + first, lineStride, dimensions[axis], weights);
        }
      });
    stride = block;
  }
}

} // namespace evolving
