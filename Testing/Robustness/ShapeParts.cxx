// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShapeParts.h"

#include <cmath>
#include <map>

namespace robustness
{

Model icosphere(int level, double radius, const Vec3& centre)
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  Model model;
  model.points = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 }, { 0, -1, g },
    { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 }, { -g, 0, -1 },
    { -g, 0, 1 } };
  model.polygons = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  for (int l = 0; l < level; ++l)
  {
    std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> middles;
    const auto middle = [&](std::int64_t a, std::int64_t b)
    {
      const auto [place, isNew] = middles.try_emplace(std::minmax(a, b), 0);
      if (isNew)
      {
        place->second =
          model.addPoint(0.5 * (model.points[std::size_t(a)] + model.points[std::size_t(b)]));
      }
      return place->second;
    };
    std::vector<Cell> split;
    for (const Cell& t : model.polygons)
    {
      const std::int64_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      split.insert(
        split.end(), { { t[0], ab, ca }, { t[1], bc, ab }, { t[2], ca, bc }, { ab, bc, ca } });
    }
    model.polygons = split;
  }
  for (Vec3& point : model.points)
  {
    point = centre + radius * point.normalized();
  }
  claimSolid(model);
  return model;
}

Model box(const Vec3& halfSides, const std::array<int, 3>& cells)
{
  Model model;
  std::map<std::array<int, 3>, std::int64_t> ids;
  const auto id = [&](const std::array<int, 3>& place)
  {
    const auto [found, isNew] = ids.try_emplace(place, 0);
    if (isNew)
    {
      Vec3 point;
      for (int a = 0; a < 3; ++a)
      {
        const auto axis = std::size_t(a);
        point[a] = halfSides[a] * (2.0 * place[axis] / cells[axis] - 1.0);
      }
      found->second = model.addPoint(point);
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (int i = 0; i < cells[u]; ++i)
    {
      for (int j = 0; j < cells[v]; ++j)
      {
        const auto corner = [&](int side, int di, int dj)
        {
          std::array<int, 3> place{};
          place[axis] = side * cells[axis];
          place[u] = i + di;
          place[v] = j + dj;
          return id(place);
        };
        model.addPolygon({ corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1) });
        model.addPolygon({ corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0) });
      }
    }
  }
  claimSolid(model);
  return model;
}

} // namespace robustness
