// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/MaterialGrid.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

MaterialGrid::MaterialGrid(
  const std::array<Index, 3>& sizes, const std::vector<Material>& materials)
  : Sizes(sizes)
{
  this->Strides = { 1, sizes[0] + 2, static_cast<GridIndex>(sizes[0] + 2) * (sizes[1] + 2) };
  this->Materials.assign(at(this->Strides[2] * (sizes[2] + 2)), OutsideImage);
  auto row = materials.begin();
  for (Index k = 0; k < sizes[2]; ++k)
  {
    for (Index j = 0; j < sizes[1]; ++j)
    {
      std::copy_n(row, sizes[0], this->Materials.begin() + this->voxel(0, j, k));
      row += sizes[0];
    }
  }
}

Octants MaterialGrid::around(const std::array<Index, 3>& corner) const
{
  const GridIndex first = this->voxel(corner[0] - 1, corner[1] - 1, corner[2] - 1);
  Octants octants{};
  for (GridIndex b = 0; b < 8; ++b)
  {
    octants[at(b)] = this->Materials[at(first + (b & 1) * this->Strides[0] +
      (b >> 1 & 1) * this->Strides[1] + (b >> 2) * this->Strides[2])];
  }
  return octants;
}

Index MaterialGrid::count(const std::array<Index, 3>& corner, Material material, Index reach) const
{
  Block block{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    block.first[axis] = std::max(corner[axis] - reach, -1);
    block.last[axis] = std::min(corner[axis] + reach - 1, this->Sizes[axis]);
  }
  Index count = 0;
  for (Index k = block.first[2]; k <= block.last[2]; ++k)
  {
    for (Index j = block.first[1]; j <= block.last[1]; ++j)
    {
      for (Index i = block.first[0]; i <= block.last[0]; ++i)
      {
        count += (*this)(i, j, k) == material ? 1 : 0;
      }
    }
  }
  return count;
}

MaterialGrid::Block MaterialGrid::blockAround(const Vec3& point, double reach) const
{
  Block block{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double coordinate = point[static_cast<Index>(axis)] + 0.5;
    const auto inLayer = [&](double place)
    { return std::clamp(static_cast<Index>(std::floor(place)), -1, this->Sizes[axis]); };
    block.first[axis] = inLayer(coordinate - reach);
    block.last[axis] = inLayer(coordinate + reach);
  }
  return block;
}

bool MaterialGrid::isNearInterface(const Vec3& point, double reach) const
{
  // From a voxel to another one in the block goes a way over faces that touch the box, too.
  const auto [first, last] = this->blockAround(point, reach);
  const Material one = (*this)(first[0], first[1], first[2]);
  for (Index k = first[2]; k <= last[2]; ++k)
  {
    for (Index j = first[1]; j <= last[1]; ++j)
    {
      for (Index i = first[0]; i <= last[0]; ++i)
      {
        if (isInterface((*this)(i, j, k), one))
        {
          return true;
        }
      }
    }
  }
  return false;
}

bool MaterialGrid::isNearFace(const Vec3& point, Material material, double reach) const
{
  const auto [first, last] = this->blockAround(point, reach);
  for (Index k = first[2]; k <= last[2]; ++k)
  {
    for (Index j = first[1]; j <= last[1]; ++j)
    {
      for (Index i = first[0]; i <= last[0]; ++i)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const std::array<Index, 3> voxel = { i, j, k };
          const GridIndex own = this->voxel(i, j, k);
          const bool isFace =
            voxel[static_cast<std::size_t>(axis)] < last[static_cast<std::size_t>(axis)] &&
            (this->Materials[at(own)] == material) !=
              (this->Materials[at(own + this->stride(axis))] == material);
          Vec3 half = Vec3::Constant(0.5);
          half[axis] = 0.0;
          const Vec3 middle = Vec3(i, j, k) + 0.5 * Vec3::Unit(axis);
          if (isFace && ((point - middle).cwiseAbs() - half).cwiseMax(0.0).norm() <= reach)
          {
            return true;
          }
        }
      }
    }
  }
  return false;
}

} // namespace evolving
