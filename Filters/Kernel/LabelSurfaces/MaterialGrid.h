// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Which material every voxel of an image belongs to.
 */

#ifndef EVOLVING_MATERIAL_GRID_H
#define EVOLVING_MATERIAL_GRID_H

#include "Types.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace evolving
{

/// A label by its number in a list, from 1; two numbers are no labels.
using Material = std::uint16_t;
constexpr Material Background = 0;
/// Of what lies around the image: other than the background, so that a surface that runs out of the
/// image ends there with an edge.
constexpr Material OutsideImage = std::numeric_limits<Material>::max();
constexpr std::size_t MostLabels = OutsideImage - 1;

/// Has a material a surface of its own?
constexpr bool isLabel(Material material)
{
  return material != Background && material != OutsideImage;
}

/// Is there an interface to draw between two voxels? Not between background and nothing.
constexpr bool isInterface(Material a, Material b)
{
  return a != b && (isLabel(a) || isLabel(b));
}

/// The eight voxels around a corner; voxel b lies along axis a where bit a of b is set.
using Octants = std::array<Material, 8>;

/**
 * Materials with a layer of OutsideImage around. Voxel (i, j, k), counted from 0 without that
 * layer, has its middle there, and the corner (i, j, k) between the voxels (i - 1, j - 1, k - 1)
 * and (i, j, k).
 */
class MaterialGrid
{
public:
  /// @param sizes voxels along the axes @param materials of all, x fastest
  MaterialGrid(const std::array<Index, 3>& sizes, const std::vector<Material>& materials);

  /// Corners along an axis: one more than voxels.
  Index cornerCount(int axis) const { return this->Sizes[static_cast<std::size_t>(axis)] + 1; }

  /// Of a voxel, which may be one of the outer layer.
  Material operator()(Index i, Index j, Index k) const
  {
    return this->Materials[at(this->voxel(i, j, k))];
  }
  Octants around(const std::array<Index, 3>& corner) const;

  /**
   * Of the voxels around a corner the smallest part: how many voxels of its material hang together
   * with it by faces, at most so many to each side of the corner. Not of the outer layer.
   */
  Index smallestPart(const std::array<Index, 3>& corner, Index reach) const;

  /// A voxel's number, and the step to the next one along an axis.
  GridIndex voxel(Index i, Index j, Index k) const
  {
    return i + 1 + this->Strides[1] * (j + 1) + this->Strides[2] * (k + 1);
  }
  GridIndex stride(int axis) const { return this->Strides[static_cast<std::size_t>(axis)]; }
  /// Is a voxel between two others along an axis, both of other materials? Not for the outer layer.
  bool isThin(GridIndex voxel, int axis) const
  {
    const GridIndex step = this->stride(axis);
    const Material own = this->Materials[at(voxel)];
    return own != OutsideImage && this->Materials[at(voxel - step)] != own &&
      this->Materials[at(voxel + step)] != own;
  }

  /// Are those two others different materials? Then it may be the end of a wedge.
  bool isWedge(GridIndex voxel, int axis) const
  {
    const GridIndex step = this->stride(axis);
    return this->Materials[at(voxel - step)] != this->Materials[at(voxel + step)];
  }
  /// Is a point at most `reach`, below half a voxel, along each axis from a face of two materials?
  bool isNearInterface(const Vec3& point, double reach) const;
  /// Is it at most `reach` from a face of one?
  bool isNearFace(const Vec3& point, Material material, double reach) const;

private:
  /// Of voxels, from the first to the last that a box touches, within the outer layer.
  struct Block
  {
    std::array<Index, 3> first;
    std::array<Index, 3> last;
  };
  Block blockAround(const Vec3& point, double reach) const;

  std::array<Index, 3> Sizes;
  std::array<GridIndex, 3> Strides{};
  std::vector<Material> Materials;
};

} // namespace evolving

#endif
