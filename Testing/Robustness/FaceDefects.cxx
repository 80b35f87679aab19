// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Defects.h"

#include <algorithm>
#include <cmath>

namespace robustness
{

namespace
{

/// Some polygons, a few or many.
std::vector<std::size_t> chooseFaces(const Model& model, Random& random)
{
  std::vector<std::size_t> chosen;
  const double share = random.logarithmic(0.01, 0.5);
  for (std::size_t f = 0; f < model.polygons.size(); ++f)
  {
    if (random.chance(share))
    {
      chosen.push_back(f);
    }
  }
  if (chosen.empty() && !model.polygons.empty())
  {
    chosen.push_back(random.index(model.polygons.size()));
  }
  return chosen;
}

void removeFaces(Model& model, Random& random)
{
  std::vector<Cell> kept;
  const std::vector<std::size_t> holes = chooseFaces(model, random);
  for (std::size_t f = 0; f < model.polygons.size(); ++f)
  {
    if (!std::binary_search(holes.begin(), holes.end(), f))
    {
      kept.push_back(model.polygons[f]);
    }
  }
  model.polygons = kept;
  model.forgetSolid();
}

void flipFaces(Model& model, Random& random)
{
  for (const std::size_t f : chooseFaces(model, random))
  {
    std::reverse(model.polygons[f].begin(), model.polygons[f].end());
  }
  model.isClean = false;
}

void flipAll(Model& model, Random&)
{
  for (Cell& polygon : model.polygons)
  {
    std::reverse(polygon.begin(), polygon.end());
  }
  model.isClean = false;
}

void duplicateFaces(Model& model, Random& random)
{
  for (const std::size_t f : chooseFaces(model, random))
  {
    model.addPolygon(Cell(model.polygons[f]));
  }
  model.hasDuplicates = true;
  model.isClean = false;
}

void duplicateFacesReversed(Model& model, Random& random)
{
  for (const std::size_t f : chooseFaces(model, random))
  {
    model.addPolygon(Cell(model.polygons[f].rbegin(), model.polygons[f].rend()));
  }
  model.hasDuplicates = true;
  model.isClean = false;
}

/// Every face with its own points, as STL files have it.
void splitToSoup(Model& model, Random&)
{
  for (Cell& polygon : model.polygons)
  {
    for (std::int64_t& id : polygon)
    {
      id = model.addPoint(Vec3(model.points[std::size_t(id)]));
    }
  }
  model.isClean = false;
}

/// Splits triangles at a point: near an edge it makes a cap, near a corner slivers.
void splitFaces(Model& model, Random& random, const Vec3& weights)
{
  for (const std::size_t f : chooseFaces(model, random))
  {
    const Cell t = model.polygons[f];
    if (t.size() != 3)
    {
      continue;
    }
    Vec3 point = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
    {
      point += weights[Eigen::Index(k)] * model.points[std::size_t(t[k])];
    }
    const std::int64_t middle = model.addPoint(point);
    model.polygons[f] = { t[0], t[1], middle };
    model.addPolygon({ t[1], t[2], middle });
    model.addPolygon({ t[2], t[0], middle });
  }
  model.hasSplits = true;
  model.isClean = false;
  if (model.hasDuplicates)
  {
    model.forgetSolid();
  }
}

void makeSlivers(Model& model, Random& random)
{
  const double near = random.logarithmic(1e-12, 0.01);
  splitFaces(model, random, { 1.0 - 2.0 * near, near, near });
}

void makeCaps(Model& model, Random& random)
{
  const double near = random.logarithmic(1e-12, 0.01);
  const double along = random.real(0.2, 0.8);
  splitFaces(model, random, { (1.0 - near) * along, (1.0 - near) * (1.0 - along), near });
}

/// Triangles whose corners are on one line, or twice the same point.
void addFacesWithoutArea(Model& model, Random& random)
{
  for (const std::size_t f : chooseFaces(model, random))
  {
    const Cell polygon = model.polygons[f];
    const std::int64_t a = polygon[0], b = polygon[1];
    if (random.chance(0.5))
    {
      const Vec3 middle = 0.5 * (model.points[std::size_t(a)] + model.points[std::size_t(b)]);
      model.addPolygon({ a, model.addPoint(middle), b });
    }
    else
    {
      model.addPolygon({ a, b, b });
    }
  }
  model.isClean = false;
}

/// Quads with their corners in the wrong order.
void addBowTies(Model& model, Random& random)
{
  for (const std::size_t f : chooseFaces(model, random))
  {
    const Cell polygon = model.polygons[f];
    Cell other = model.polygons[random.index(model.polygons.size())];
    model.addPolygon({ polygon[0], other[1], polygon[1], other[0] });
  }
  model.forgetSolid();
}

/// A polygon of many corners, in a plane or not.
void addBigPolygon(Model& model, Random& random)
{
  Cell polygon;
  const int corners = random.integer(5, 60);
  const double out = random.chance(0.5) ? 0.0 : random.real(0.0, 0.3);
  for (int k = 0; k < corners; ++k)
  {
    const double turn = 6.283185307179586 * k / corners;
    const double radius = k % 2 == 0 ? 1.0 : random.real(0.2, 1.0);
    polygon.push_back(model.addPoint({ 2.5 + radius * std::cos(turn), radius * std::sin(turn),
      out == 0.0 ? 0.0 : random.real(-out, out) }));
  }
  model.addPolygon(polygon);
  model.forgetSolid();
}

/// Fans become strips: a strip of one triangle is one, a longer one takes its neighbour's point.
void useStrips(Model& model, Random& random)
{
  std::vector<Cell> kept;
  for (const Cell& polygon : model.polygons)
  {
    const bool becomesStrip = random.chance(0.5) && polygon.size() <= 4;
    if (becomesStrip && polygon.size() == 4)
    {
      model.strips.push_back({ polygon[0], polygon[1], polygon[3], polygon[2] });
    }
    else
    {
      (becomesStrip ? model.strips : kept).push_back(polygon);
    }
  }
  model.polygons = kept;
  model.isClean = false;
}

void addTooSmallCells(Model& model, Random& random)
{
  const std::int64_t a = 0, b = std::int64_t(model.points.size()) - 1;
  const std::vector<Cell> cells{ {}, { a }, { a, b } };
  const Cell& cell = random.pick(cells);
  (random.chance(0.3) ? model.strips : model.polygons).push_back(cell);
  model.forgetSolid();
}

} // namespace

const std::vector<Defect>& faceDefects()
{
  static const std::vector<Defect> defects{ { "holes", removeFaces }, { "flips", flipFaces },
    { "inside out", flipAll }, { "duplicates", duplicateFaces },
    { "reversed duplicates", duplicateFacesReversed }, { "soup", splitToSoup },
    { "slivers", makeSlivers }, { "caps", makeCaps }, { "no area", addFacesWithoutArea },
    { "bow ties", addBowTies }, { "big polygon", addBigPolygon }, { "strips", useStrips },
    { "too small cells", addTooSmallCells } };
  return defects;
}

} // namespace robustness
