// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What shapes are built of.
 */

#ifndef ROBUSTNESS_SHAPE_PARTS_H
#define ROBUSTNESS_SHAPE_PARTS_H

#include "Model.h"

namespace robustness
{

constexpr double Pi = 3.14159265358979323846;

///@{
/// Closed, around the origin or a centre.
Model icosphere(int level, double radius, const Vec3& centre);
Model box(const Vec3& halfSides, const std::array<int, 3>& cells);
///@}

/// A surface over a grid of parameters; wrapped sides are joined to their opposite ones.
template <typename Map>
Model lattice(int nu, int nv, bool wrapU, bool wrapV, const Map& map)
{
  Model model;
  const int pointsU = wrapU ? nu : nu + 1;
  const int pointsV = wrapV ? nv : nv + 1;
  for (int j = 0; j < pointsV; ++j)
  {
    for (int i = 0; i < pointsU; ++i)
    {
      model.addPoint(map(double(i) / nu, double(j) / nv));
    }
  }
  const auto id = [&](int i, int j) -> std::int64_t
  { return std::int64_t(j % pointsV) * pointsU + i % pointsU; };
  for (int j = 0; j < nv; ++j)
  {
    for (int i = 0; i < nu; ++i)
    {
      model.addPolygon({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      model.addPolygon({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  return model;
}

///@{
/// Surfaces with a border, or without an inside.
Model makeSheet(Random& random);
Model makeTube(Random& random);
Model makeBand(Random& random);
Model makeKleinBottle(Random& random);
///@}

} // namespace robustness

#endif
