// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/FloatRange.h"

#include "Errors.h"

#include <limits>
#include <sstream>

namespace evolving
{

void requireSizeForFloats(const Box& mesh)
{
  // A grid of 65536 samples along one axis and 2 along the others is so many times longer than
  // the mesh: with these sizes it has no distance that overflows and no cell that vanishes.
  constexpr double Smallest = 1e-31;
  constexpr double Largest = 1e31;
  const double size = mesh.sizes().maxCoeff();
  if (size != 0.0 && !(size >= Smallest && size <= Largest))
  {
    std::ostringstream message;
    message << "The mesh is " << size << " long, expected a size between " << Smallest << " and "
            << Largest << " so that distances fit into single precision; scale it to another unit.";
    throw InputError(message.str());
  }
}

void requireDistancesForFloats(const Box& mesh, const DistanceGrid& grid)
{
  using Float = std::numeric_limits<float>;
  const Extent& e = grid.extent;
  Box all = mesh;
  all.extend(grid.point(e[0], e[2], e[4]));
  all.extend(grid.point(e[1], e[3], e[5]));
  const double farthest = all.diagonal().norm();
  if (!(farthest < Float::max()) || grid.spacing.minCoeff() < Float::min())
  {
    std::ostringstream message;
    message << "The grid has cells of " << grid.spacing.minCoeff() << " and distances up to "
            << farthest << ", which single precision cannot hold; correct ModelBounds, or scale "
            << "the mesh to another unit.";
    throw InputError(message.str());
  }
}

} // namespace evolving
