// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/DistanceGrid.h"

#include "Errors.h"
#include "ParameterRange.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace evolving
{

namespace
{

void requirePositive(const std::array<int, 3>& dimensions)
{
  for (const int dimension : dimensions)
  {
    if (dimension < 1)
    {
      std::ostringstream message;
      message << "The grid has " << dimensions[0] << " x " << dimensions[1] << " x "
              << dimensions[2] << " samples, expected at least 1 along every axis.";
      throw InputError(message.str());
    }
  }
}

Extent extentOf(const std::array<int, 3>& dimensions)
{
  return { 0, dimensions[0] - 1, 0, dimensions[1] - 1, 0, dimensions[2] - 1 };
}

/// The side of the smallest cube that lets `dimensions` cubes cover the size on every axis.
double cubeSide(const Vec3& size, const std::array<int, 3>& dimensions)
{
  double side = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = dimensions[static_cast<std::size_t>(axis)] - 1;
    side = cells > 0 ? std::max(side, size[axis] / cells) : side;
  }
  // One sample in all, or a box without extent along every sampled axis.
  side = side > 0.0 ? side : size.maxCoeff();
  return side > 0.0 ? side : 1.0;
}

} // namespace

int DistanceGrid::dimension(int axis) const
{
  const auto first = static_cast<std::size_t>(2 * axis);
  return std::max(0, this->extent[first + 1] - this->extent[first] + 1);
}

GridIndex DistanceGrid::sampleCount() const
{
  return GridIndex(this->dimension(0)) * this->dimension(1) * this->dimension(2);
}

GridIndex DistanceGrid::index(int i, int j, int k) const
{
  const GridIndex row = GridIndex(k - this->extent[4]) * this->dimension(1) + (j - this->extent[2]);
  return row * this->dimension(0) + (i - this->extent[0]);
}

Vec3 DistanceGrid::point(int i, int j, int k) const
{
  return this->origin + this->spacing.cwiseProduct(Vec3(i, j, k));
}

bool DistanceGrid::isCubic() const
{
  double smallest = std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (this->dimension(axis) > 1)
    {
      smallest = std::min(smallest, this->spacing[axis]);
      largest = std::max(largest, this->spacing[axis]);
    }
  }
  constexpr double Rounding = 1e-5; // bounds typed in with a few decimals still make cubes
  return largest == 0.0 || largest - smallest <= Rounding * largest;
}

DistanceGrid DistanceGrid::part(const Extent& partExtent) const
{
  DistanceGrid grid = *this;
  grid.extent = partExtent;
  return grid;
}

DistanceGrid gridAround(const Box& box, const std::array<int, 3>& dimensions, double padding)
{
  requirePositive(dimensions);
  checkRange("Padding", padding, 0.0, AnyNumber, "0 means none");
  const Vec3 center = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
  const Vec3 sides = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
  const Vec3 padded = sides + Vec3::Constant(2.0 * padding * sides.maxCoeff());
  DistanceGrid grid;
  grid.extent = extentOf(dimensions);
  grid.spacing.setConstant(cubeSide(padded, dimensions));
  const Vec3 cells(dimensions[0] - 1, dimensions[1] - 1, dimensions[2] - 1);
  grid.origin = center - 0.5 * grid.spacing.cwiseProduct(cells);
  return grid;
}

DistanceGrid gridOver(const Box& box, const std::array<int, 3>& dimensions)
{
  requirePositive(dimensions);
  DistanceGrid grid;
  grid.extent = extentOf(dimensions);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int cells = dimensions[static_cast<std::size_t>(axis)] - 1;
    const double side = box.sizes()[axis];
    if (!(side >= 0.0) || !std::isfinite(side) || (cells > 0 && side == 0.0))
    {
      std::ostringstream message;
      message << "ModelBounds goes from " << box.min()[axis] << " to " << box.max()[axis]
              << " along "
              << "xyz"[axis] << " with " << cells + 1
              << " samples, expected a positive length; correct it, or set 1 -1 1 -1 1 -1 for an "
                 "automatic box.";
      throw InputError(message.str());
    }
    grid.origin[axis] = cells > 0 ? box.min()[axis] : box.center()[axis];
    grid.spacing[axis] = cells > 0 ? side / cells : (side > 0.0 ? side : 1.0);
  }
  return grid;
}

} // namespace evolving
