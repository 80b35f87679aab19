// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/AutomaticEdgeDetector.h"

#include "Distance/GaussianSmoothing.h"
#include "Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// In samples; variance 0.64, that of central differences is a third.
constexpr double Smoothing = 0.8;
/// Variances, in squared samples: of central differences, and of what a sample is the mean over.
constexpr double OfDifferences = 1.0 / 3.0;
constexpr double OfSamples = 1.0 / 12.0;
/// Of the gradients that are not zero, the part that is taken for noise; few enough that an image
/// may have more edges than flat places.
constexpr double NoisePart = 0.1;
/// Of Gaussian noise: 5 standard deviations of a component by the length that NoisePart of the
/// gradients are below (0.764, the root of that quantile of chi-squared for three components).
constexpr double LargestNoise = 5.0 / 0.764;
/// By the longest: shorter gradients are zero but for rounding, as where an image is masked.
constexpr double SmallestGradient = 1e-6;
/// An edge by the largest noise: what noise has above that, by chance, is hardly longer.
constexpr double LeastEdge = 1.25;
/// 1 / e - 1 at a typical edge.
constexpr double Depth = 9.0;

using Ijk = std::array<int, 3>;

/// Calls body(ijk, sample) for the samples of one slice.
template <class Body>
void forEachInSlice(const DistanceGrid& grid, int k, const Body& body)
{
  const Extent& extent = grid.extent;
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    for (int i = extent[0]; i <= extent[1]; ++i)
    {
      body(Ijk{ i, j, k }, static_cast<std::size_t>(grid.index(i, j, k)));
    }
  }
}

template <class Body>
void forEachSlice(const DistanceGrid& grid, const Execution& execution, const Body& body)
{
  execution.forRangeReporting(grid.dimension(2), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t slice = begin; slice < end; ++slice)
      {
        body(static_cast<int>(slice));
      }
    });
}

[[noreturn]] void refuse(const std::string& what)
{
  throw InputError("The image " + what +
    ", expected objects whose intensity differs from what is around them; choose another array, "
    "set FieldMode to what the image is, or set EdgeSharpness.");
}

/// Continued by its mirror image at all sides: what lies there is no edge, and no less noisy.
std::vector<float> mirrored(const ScalarImage& image, const DistanceGrid& larger)
{
  const DistanceGrid& grid = image.grid();
  std::vector<float> values(static_cast<std::size_t>(larger.sampleCount()));
  for (int k = larger.extent[4]; k <= larger.extent[5]; ++k)
  {
    forEachInSlice(larger, k,
      [&](Ijk p, std::size_t sample)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const int first = grid.extent[2 * axis];
          const int last = grid.extent[2 * axis + 1];
          const int inside = p[axis] < first ? 2 * first - p[axis] : p[axis];
          p[axis] = std::clamp(inside > last ? 2 * last - inside : inside, first, last);
        }
        values[sample] = image.values()[static_cast<std::size_t>(grid.index(p[0], p[1], p[2]))];
      });
  }
  return values;
}

/// The image without most of its noise, along its own axes, and larger.
ScalarImage smoothed(const ScalarImage& image, const Execution& execution)
{
  DistanceGrid grid = image.grid();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int margin = grid.dimension(static_cast<int>(axis)) > 1 ? smoothingRadius(Smoothing) : 0;
    grid.extent[2 * axis] -= margin;
    grid.extent[2 * axis + 1] += margin;
  }
  std::vector<float> values = mirrored(image, grid);
  smoothGaussian(
    values, { grid.dimension(0), grid.dimension(1), grid.dimension(2) }, Smoothing, execution);
  return ScalarImage(grid, std::move(values));
}

/// How fast intensities could change at most: the unit in which gradients are small numbers.
double steepestSlope(const ScalarImage& image)
{
  const auto [low, high] = std::minmax_element(image.values().begin(), image.values().end());
  const double range = static_cast<double>(*high) - static_cast<double>(*low);
  return range / image.grid().spacing.minCoeff();
}

/// Of the smoothed image at the samples of the grid.
std::vector<float> slopes(
  const ScalarImage& smooth, const DistanceGrid& grid, double unit, const Execution& execution)
{
  std::vector<float> slope(static_cast<std::size_t>(grid.sampleCount()));
  forEachSlice(grid, execution,
    [&](int slice)
    {
      forEachInSlice(grid, grid.extent[4] + slice,
        [&](const Ijk& p, std::size_t sample)
        {
          const double length = smooth.gradientAtSample(p[0], p[1], p[2]).norm();
          slope[sample] = static_cast<float>(length / unit);
        });
    });
  return slope;
}

double quantile(std::vector<float>& values, double part)
{
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * double(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double largestNoise(const std::vector<float>& slope)
{
  const double longest = *std::max_element(slope.begin(), slope.end());
  std::vector<float> changing;
  std::copy_if(slope.begin(), slope.end(), std::back_inserter(changing),
    [&](float length) { return length > SmallestGradient * longest; });
  return changing.empty() ? 0.0 : LargestNoise * quantile(changing, NoisePart);
}

/// Is the slope at an inner sample as large as those before and behind, along the axis across which
/// the image changes most?
bool isRidge(const ScalarImage& smooth, const DistanceGrid& grid, const std::vector<float>& slope,
  const Ijk& p)
{
  Eigen::Index axis = 0;
  smooth.gradientAtSample(p[0], p[1], p[2]).cwiseAbs().maxCoeff(&axis);
  const auto a = static_cast<std::size_t>(axis);
  if (p[a] == grid.extent[2 * a] || p[a] == grid.extent[2 * a + 1])
  {
    return false;
  }
  const auto slopeAt = [&](int offset)
  {
    Ijk q = p;
    q[a] += offset;
    return slope[static_cast<std::size_t>(grid.index(q[0], q[1], q[2]))];
  };
  return slopeAt(0) >= slopeAt(-1) && slopeAt(0) > slopeAt(1);
}

/// The median slope of edges; 0 when there are none.
double typicalEdge(const ScalarImage& smooth, const DistanceGrid& grid,
  const std::vector<float>& slope, double noise, const Execution& execution)
{
  std::vector<std::vector<float>> ofSlices(static_cast<std::size_t>(grid.dimension(2)));
  forEachSlice(grid, execution,
    [&](int slice)
    {
      forEachInSlice(grid, grid.extent[4] + slice,
        [&](const Ijk& p, std::size_t sample)
        {
          if (slope[sample] > noise && isRidge(smooth, grid, slope, p))
          {
            ofSlices[static_cast<std::size_t>(slice)].push_back(slope[sample]);
          }
        });
    });
  std::vector<float> edges;
  for (const std::vector<float>& ofSlice : ofSlices)
  {
    edges.insert(edges.end(), ofSlice.begin(), ofSlice.end());
  }
  return edges.empty() ? 0.0 : quantile(edges, 0.5);
}

} // namespace

EdgeDetector automaticEdgeDetector(const ScalarImage& image, const Execution& execution)
{
  const double unit = steepestSlope(image);
  if (!(unit > 0.0) || !std::isfinite(unit))
  {
    refuse("has one intensity only");
  }
  const ScalarImage smooth = smoothed(image, execution.phase(0.0, 0.4));
  std::vector<float> slope = slopes(smooth, image.grid(), unit, execution.phase(0.4, 0.7));
  const double noise = largestNoise(slope);
  const double edge = typicalEdge(smooth, image.grid(), slope, noise, execution.phase(0.7, 1.0));
  if (!(edge > LeastEdge * noise))
  {
    refuse("has no edges that stand out from its noise");
  }
  const double sharpness = Depth / (edge * edge - noise * noise);
  for (float& value : slope)
  {
    const double excess = std::max(0.0, double(value) * value - noise * noise);
    value = static_cast<float>(1.0 / (1.0 + sharpness * excess));
  }
  const double blur =
    (Smoothing * Smoothing + OfDifferences + OfSamples) * image.grid().spacing.squaredNorm() / 3.0;
  return { std::make_shared<const ScalarImage>(image.grid(), std::move(slope), image.axes()),
    sharpness / (unit * unit), noise * unit, blur };
}

} // namespace evolving
