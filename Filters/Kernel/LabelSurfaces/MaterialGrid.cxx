// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/MaterialGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

Index MaterialGrid::smallestPart(const std::array<Index, 3>& corner, Index reach) const
{
  // Cells of the cube of voxels around the corner, those outside the outer layer left out.
  const Index side = 2 * reach;
  std::vector<char> isReached(at(side * side * side), 0);
  std::vector<std::array<Index, 3>> part;
  const auto add = [&](const std::array<Index, 3>& cell, Material material)
  {
    std::array<Index, 3> voxel{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      voxel[axis] = corner[axis] - reach + cell[axis];
      if (cell[axis] < 0 || cell[axis] >= side || voxel[axis] < -1 ||
        voxel[axis] > this->Sizes[axis])
      {
        return;
      }
    }
    char& has = isReached[at(cell[0] + side * (cell[1] + side * cell[2]))];
    if (has == 0 && (*this)(voxel[0], voxel[1], voxel[2]) == material)
    {
      has = 1;
      part.push_back(cell);
    }
  };
  const Octants octants = this->around(corner);
  Index smallest = std::numeric_limits<Index>::max();
  for (Index b = 0; b < 8; ++b)
  {
    const Material material = octants[at(b)];
    part.clear();
    add({ reach - 1 + (b & 1), reach - 1 + (b >> 1 & 1), reach - 1 + (b >> 2) }, material);
    if (part.empty() || material == OutsideImage)
    {
      continue;
    }
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (const Index way : { -1, 1 })
        {
          std::array<Index, 3> next = part[i];
          next[axis] += way;
          add(next, material);
        }
      }
    }
    smallest = std::min(smallest, static_cast<Index>(part.size()));
  }
  return smallest;
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
