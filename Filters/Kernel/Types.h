// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The vocabulary of the kernel: vectors, boxes and index types.
 */

#ifndef EVOLVING_TYPES_H
#define EVOLVING_TYPES_H

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>

namespace evolving
{

/// A point or a vector in space, in the input's length unit.
using Vec3 = Eigen::Vector3d;

/// An axis-aligned box; a default one is empty.
using Box = Eigen::AlignedBox3d;

/// A vertex, a face, an edge or a corner of a mesh.
using Index = std::int32_t;

/// A sample of a grid: grids exceed 2^31 samples, so this is always 64 bits wide.
using GridIndex = std::int64_t;

/// "There is none": no opposite corner, no closest triangle.
constexpr Index NoIndex = -1;

///@{
/// An index that is one, not NoIndex, as the index of an array.
constexpr std::size_t at(Index i)
{
  return static_cast<std::size_t>(i);
}
constexpr std::size_t at(GridIndex i)
{
  return static_cast<std::size_t>(i);
}
///@}

} // namespace evolving

#endif
