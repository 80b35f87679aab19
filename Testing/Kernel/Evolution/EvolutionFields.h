// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Images with known answers for the tests of the evolution folder.
 */

#ifndef EVOLVING_EVOLUTION_FIELDS_H
#define EVOLVING_EVOLUTION_FIELDS_H

#include "Distance/DistanceGrid.h"
#include "Evolution/ScalarImage.h"
#include "Shapes/SampledOnGrid.h"

#include <functional>
#include <memory>
#include <vector>

namespace evolving::shapes
{

inline std::shared_ptr<const ScalarImage> image(
  const DistanceGrid& grid, const std::function<double(const Vec3&)>& function)
{
  return std::make_shared<const ScalarImage>(grid, sampled(grid, function));
}

/// The signed distance from a sphere about the origin.
inline std::shared_ptr<const ScalarImage> sphereField(int n, double half, double radius)
{
  return image(cubicGrid(n, half), [=](const Vec3& p) { return p.norm() - radius; });
}

} // namespace evolving::shapes

#endif
