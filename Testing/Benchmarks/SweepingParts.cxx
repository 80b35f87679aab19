// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SweepingParts.h"

#include <cmath>

namespace benchmark
{

evolving::DistanceGrid cubeGrid(const evolving::SurfaceMesh& mesh, int size)
{
  constexpr double Padding = 0.1;
  return evolving::gridAround(evolving::boundingBox(mesh), { size, size, size }, Padding);
}

evolving::SweptField frozenField(
  const evolving::DistanceOctree& octree, const evolving::DistanceGrid& grid)
{
  const double h = grid.spacing.maxCoeff();
  evolving::SweptField field({ grid.dimension(0), grid.dimension(1), grid.dimension(2) });
  for (const evolving::DistanceOctree::Leaf& leaf : octree.leaves())
  {
    const auto& [i, j, k] = leaf.cell.corner;
    field.freeze(grid.index(i, j, k), static_cast<float>(std::sqrt(leaf.squaredDistance) / h));
  }
  return field;
}

evolving::SignedDistanceResult wholeDistance(const evolving::SurfaceMesh& mesh, int size,
  evolving::DistanceMethod method, evolving::SignMethod sign, const evolving::Execution& execution)
{
  const evolving::DistanceGrid grid = cubeGrid(mesh, size);
  evolving::SignedDistanceOptions options;
  options.method = method;
  options.sign = sign;
  return evolving::signedDistance(mesh, grid, grid.extent, options, execution);
}

} // namespace benchmark
