// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ScalarImage.h"

#include "Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace evolving
{

namespace
{

/// Where a point lies along one axis: between samples `low` and `low + 1`, at `fraction`.
struct AxisPosition
{
  int low = 0;
  double fraction = 0.0;
  double outside = 0.0; ///< signed distance beyond the first or last sample; 0 between them
};

AxisPosition locate(const DistanceGrid& grid, int axis, double coordinate)
{
  const int first = grid.extent[static_cast<std::size_t>(2 * axis)];
  const int last = grid.extent[static_cast<std::size_t>(2 * axis + 1)];
  AxisPosition position;
  position.low = first;
  if (first == last)
  {
    return position; // one sample: nothing is known to change along this axis
  }
  const double samples = (coordinate - grid.origin[axis]) / grid.spacing[axis];
  const double inside = std::clamp(samples, static_cast<double>(first), static_cast<double>(last));
  position.low = std::min(static_cast<int>(std::floor(inside)), last - 1);
  position.fraction = inside - position.low;
  position.outside = (samples - inside) * grid.spacing[axis];
  return position;
}

/// Values and central differences at the samples of one grid.
class Samples
{
public:
  Samples(const DistanceGrid& grid, const std::vector<float>& values)
    : Grid(grid)
    , Values(values)
  {
  }

  double value(const std::array<int, 3>& ijk) const
  {
    return this->Values[static_cast<std::size_t>(this->Grid.index(ijk[0], ijk[1], ijk[2]))];
  }

  /// Central differences, one-sided at the border, zero along an axis of one sample.
  Vec3 gradient(const std::array<int, 3>& ijk) const
  {
    Vec3 gradient = Vec3::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::array<int, 3> before = ijk;
      std::array<int, 3> after = ijk;
      before[axis] = std::max(ijk[axis] - 1, this->Grid.extent[2 * axis]);
      after[axis] = std::min(ijk[axis] + 1, this->Grid.extent[2 * axis + 1]);
      const int steps = after[axis] - before[axis];
      if (steps > 0)
      {
        const auto a = static_cast<Eigen::Index>(axis);
        gradient[a] = (this->value(after) - this->value(before)) / (steps * this->Grid.spacing[a]);
      }
    }
    return gradient;
  }

private:
  const DistanceGrid& Grid;
  const std::vector<float>& Values;
};

/**
 * Outside, the field is the value at the closest point plus the distance to it. Its
 * gradient is the part along the grid's face plus the outward direction, made a unit vector.
 */
void continueOutside(const Vec3& outside, ScalarImage::Sample& sample)
{
  const double distance = outside.norm();
  if (distance == 0.0)
  {
    return;
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    sample.gradient[axis] = outside[axis] != 0.0 ? 0.0 : sample.gradient[axis];
  }
  sample.value += distance;
  sample.gradient = (sample.gradient + outside / distance).normalized();
}

void checkGrid(const DistanceGrid& grid, std::size_t valueCount)
{
  const bool empty = grid.dimension(0) < 1 || grid.dimension(1) < 1 || grid.dimension(2) < 1;
  if (empty || !(grid.spacing.minCoeff() > 0.0) || !grid.spacing.allFinite() ||
    !grid.origin.allFinite())
  {
    std::ostringstream message;
    message << "The image has " << grid.dimension(0) << " x " << grid.dimension(1) << " x "
            << grid.dimension(2) << " samples with spacing (" << grid.spacing.transpose()
            << ") from (" << grid.origin.transpose()
            << "), expected at least one sample along each axis, positive spacings and a finite "
               "origin; resample it, or flip it by its direction matrix.";
    throw InputError(message.str());
  }
  if (static_cast<GridIndex>(valueCount) != grid.sampleCount())
  {
    std::ostringstream message;
    message << "The image has " << valueCount << " values, expected one for each of its "
            << grid.sampleCount() << " samples.";
    throw InputError(message.str());
  }
}

void checkFinite(const std::vector<float>& values)
{
  const auto bad =
    std::count_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
  if (bad > 0)
  {
    std::ostringstream message;
    message << bad << " of the image's " << values.size()
            << " values are not finite, expected numbers; replace them, or compute the image with "
               "Mesh SDF.";
    throw InputError(message.str());
  }
}

} // namespace

ScalarImage::ScalarImage(const DistanceGrid& grid, std::vector<float> values, const ImageAxes& axes)
  : Grid(grid)
  , Axes(axes)
  , Values(std::move(values))
{
  checkGrid(this->Grid, this->Values.size());
  checkFinite(this->Values);
}

ScalarImage::Sample ScalarImage::at(const Vec3& point) const
{
  Sample sample = this->atOwnPoint(this->Axes.pointFromWorld(point));
  sample.gradient = this->Axes.vectorToWorld(sample.gradient);
  return sample;
}

ScalarImage::Sample ScalarImage::atOwnPoint(const Vec3& point) const
{
  const Samples samples(this->Grid, this->Values);
  std::array<AxisPosition, 3> along;
  Vec3 outside;
  for (int axis = 0; axis < 3; ++axis)
  {
    along[static_cast<std::size_t>(axis)] = locate(this->Grid, axis, point[axis]);
    outside[axis] = along[static_cast<std::size_t>(axis)].outside;
  }
  Sample sample;
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<int, 3> ijk;
    double weight = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int high = (corner >> axis) & 1;
      ijk[axis] = along[axis].low + high;
      weight *= high ? along[axis].fraction : 1.0 - along[axis].fraction;
    }
    if (weight > 0.0) // keeps the upper corners of an axis of one sample out
    {
      sample.value += weight * samples.value(ijk);
      sample.gradient += weight * samples.gradient(ijk);
    }
  }
  continueOutside(outside, sample);
  return sample;
}

Vec3 ScalarImage::gradientAtSample(int i, int j, int k) const
{
  return this->Axes.vectorToWorld(Samples(this->Grid, this->Values).gradient({ i, j, k }));
}

Box ScalarImage::box() const
{
  const Extent& e = this->Grid.extent;
  return this->Axes.boxInWorld(
    Box(this->Grid.point(e[0], e[2], e[4]), this->Grid.point(e[1], e[3], e[5])));
}

Box ScalarImage::insideBox() const
{
  Box box;
  std::size_t sample = 0;
  const Extent& e = this->Grid.extent;
  for (int k = e[4]; k <= e[5]; ++k)
  {
    for (int j = e[2]; j <= e[3]; ++j)
    {
      for (int i = e[0]; i <= e[1]; ++i, ++sample)
      {
        if (this->Values[sample] <= 0.0f)
        {
          box.extend(this->Grid.point(i, j, k));
        }
      }
    }
  }
  return box;
}

} // namespace evolving
