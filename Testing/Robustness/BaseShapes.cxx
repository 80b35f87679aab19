// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BaseShapes.h"

#include "ShapeParts.h"

#include <cmath>

namespace robustness
{

namespace
{

/// Turns a profile of (radius, height) with radius 0 at both ends around the z axis.
Model revolved(const std::vector<std::array<double, 2>>& profile, int n)
{
  Model model;
  std::vector<Cell> rings;
  for (const auto& [radius, height] : profile)
  {
    Cell ring;
    for (int i = 0; i < (radius > 0.0 ? n : 1); ++i)
    {
      const double angle = 2.0 * Pi * i / n;
      ring.push_back(
        model.addPoint({ radius * std::cos(angle), radius * std::sin(angle), height }));
    }
    rings.push_back(ring);
  }
  for (std::size_t r = 0; r + 1 < rings.size(); ++r)
  {
    for (std::size_t i = 0; i < std::size_t(n); ++i)
    {
      const auto corner = [&](std::size_t ring, std::size_t k)
      { return rings[ring][k % rings[ring].size()]; };
      const std::int64_t a = corner(r, i), b = corner(r, i + 1);
      const std::int64_t c = corner(r + 1, i + 1), d = corner(r + 1, i);
      if (a != b)
      {
        model.addPolygon({ a, b, c });
      }
      if (c != d)
      {
        model.addPolygon({ a, c, d });
      }
    }
  }
  return model;
}

Model closed(Model model)
{
  claimSolid(model);
  return model;
}

Model makeSphere(Random& random)
{
  return icosphere(random.integer(0, 3), 1.0, Vec3::Zero());
}

/// Also thin plates and long bars.
Model makeBox(Random& random)
{
  const auto side = [&]() { return random.chance(0.2) ? random.logarithmic(1e-3, 0.1) : 1.0; };
  return box({ side(), side(), side() },
    { random.integer(1, 4), random.integer(1, 4), random.integer(1, 4) });
}

Model makeTorus(Random& random)
{
  const double tube = random.real(0.1, 0.45);
  return closed(lattice(random.integer(8, 24), random.integer(5, 12), true, true,
    [tube](double u, double v) -> Vec3
    {
      const double radius = 1.0 + tube * std::cos(2.0 * Pi * v);
      return { radius * std::cos(2.0 * Pi * u), radius * std::sin(2.0 * Pi * u),
        tube * std::sin(2.0 * Pi * v) };
    }));
}

/// Cones, cylinders, spindles and hourglasses.
Model makeRevolved(Random& random)
{
  std::vector<std::array<double, 2>> profile{ { 0.0, -1.0 } };
  const int rings = random.integer(1, 6);
  for (int k = 0; k < rings; ++k)
  {
    const double height = rings == 1 ? random.real(-0.9, 0.9) : -0.999 + 1.998 * k / (rings - 1.0);
    profile.push_back({ random.chance(0.2) ? 0.05 : random.real(0.2, 1.0), height });
  }
  profile.push_back({ 0.0, 1.0 });
  return closed(revolved(profile, random.integer(3, 20)));
}

/// A thick bowl: inner and outer wall in one profile.
Model makeBowl(Random& random)
{
  const double wall = random.logarithmic(0.01, 0.3);
  const int rings = random.integer(3, 8);
  std::vector<std::array<double, 2>> profile{ { 0.0, -1.0 } };
  for (int k = 1; k <= rings; ++k)
  {
    const double angle = 0.5 * Pi * k / rings;
    profile.push_back({ std::sin(angle), -std::cos(angle) });
  }
  for (int k = rings; k >= 1; --k)
  {
    const double angle = 0.5 * Pi * k / rings;
    profile.push_back({ (1.0 - wall) * std::sin(angle), -(1.0 - wall) * std::cos(angle) });
  }
  profile.push_back({ 0.0, -(1.0 - wall) });
  return closed(revolved(profile, random.integer(5, 16)));
}

/// A prism over a concave polygon: polygons of many corners, sharp edges.
Model makePrism(Random& random)
{
  const int corners = 2 * random.integer(3, 8);
  const double waist = random.real(0.2, 0.8);
  const double height = random.logarithmic(0.01, 1.0);
  Model model;
  Cell bottom;
  Cell top;
  for (int k = 0; k < corners; ++k)
  {
    const double angle = 2.0 * Pi * k / corners;
    const double radius = k % 2 == 0 ? 1.0 : waist;
    bottom.push_back(
      model.addPoint({ radius * std::cos(angle), radius * std::sin(angle), -height }));
    top.push_back(model.addPoint({ radius * std::cos(angle), radius * std::sin(angle), height }));
  }
  for (std::size_t k = 0; k < bottom.size(); ++k)
  {
    const std::size_t next = (k + 1) % bottom.size();
    model.addPolygon({ bottom[k], bottom[next], top[next], top[k] });
  }
  model.addPolygon(top);
  model.addPolygon(Cell(bottom.rbegin(), bottom.rend()));
  return closed(model);
}

Model makeSpikedSphere(Random& random)
{
  Model model = icosphere(random.integer(1, 3), 1.0, Vec3::Zero());
  for (Vec3& point : model.points)
  {
    point *= random.chance(0.1) ? random.real(1.0, 2.0) : 1.0;
  }
  return model;
}

Model makePartsApart(Random& random)
{
  Model model;
  const int parts = random.integer(2, 5);
  for (int k = 0; k < parts; ++k)
  {
    const double size = random.logarithmic(0.05, 0.45);
    append(icosphere(random.integer(0, 2), size, Vec3(k, 0.0, 0.0)), model);
  }
  model.isClean = true;
  return model;
}

/// A ball with a hollow: the inner shell faces the other way.
Model makeHollow(Random& random)
{
  Model model = icosphere(2, 1.0, Vec3::Zero());
  Model inner = icosphere(random.integer(0, 2), random.real(0.1, 0.8), Vec3::Zero());
  for (Cell& polygon : inner.polygons)
  {
    std::swap(polygon[0], polygon[1]);
  }
  append(inner, model);
  model.forgetSolid(); // Flood Fill has the hollow inside, the others not
  return model;
}

/// Thin bars side by side: a wrap that stands on less than its edge length.
Model makeBars(Random& random)
{
  Model model;
  const int bars = random.integer(2, 15);
  const double thickness = random.logarithmic(0.005, 0.05);
  for (int k = 0; k < bars; ++k)
  {
    Model bar = box({ 1.0, thickness, thickness }, { random.integer(1, 6), 1, 1 });
    for (Vec3& point : bar.points)
    {
      point.y() += 4.0 * thickness * k;
    }
    append(bar, model);
  }
  model.isClean = true;
  return model;
}

/// Quads that are not planar.
Model makeQuadSphere(Random& random)
{
  const int n = random.integer(1, 6);
  Model model = box({ 1.0, 1.0, 1.0 }, { n, n, n });
  for (Vec3& point : model.points)
  {
    point.normalize();
  }
  model.forgetSolid();
  return model;
}

} // namespace

const std::vector<BaseShape>& baseShapes()
{
  static const std::vector<BaseShape> shapes{ { "sphere", makeSphere }, { "box", makeBox },
    { "torus", makeTorus }, { "revolved", makeRevolved }, { "bowl", makeBowl },
    { "prism", makePrism }, { "spiked sphere", makeSpikedSphere },
    { "parts apart", makePartsApart }, { "hollow", makeHollow }, { "bars", makeBars },
    { "quad sphere", makeQuadSphere }, { "sheet", makeSheet }, { "tube", makeTube },
    { "band", makeBand }, { "Klein bottle", makeKleinBottle } };
  return shapes;
}

} // namespace robustness
