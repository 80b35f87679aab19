// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BaseShapes.h"
#include "Defects.h"

#include <algorithm>
#include <cmath>

namespace robustness
{

namespace
{

Vec3 cornerOf(const Model& model, const Cell& polygon, std::size_t k)
{
  return model.points[std::size_t(polygon[k % polygon.size()])];
}

Vec3 unitNormalOf(const Model& model, const Cell& polygon)
{
  const Vec3 a = cornerOf(model, polygon, 0);
  const Vec3 normal = (cornerOf(model, polygon, 1) - a).cross(cornerOf(model, polygon, 2) - a);
  return normal.norm() > 0.0 ? Vec3(normal.normalized()) : Vec3(0.0, 0.0, 1.0);
}

/// A copy of some faces next to them: 1e-15 apart it is nearly the same, 1e-3 a thin gap.
void addSheets(Model& model, Random& random)
{
  const double gap = random.logarithmic(1e-15, 1e-3) * radiusOf(model);
  const std::size_t faces = model.polygons.size();
  const std::size_t first = random.index(faces);
  const std::size_t last = std::min(faces, first + 1 + random.index(faces));
  for (std::size_t f = first; f < last; ++f)
  {
    Cell copy = model.polygons[f];
    const Vec3 offset = gap * unitNormalOf(model, copy);
    for (std::int64_t& id : copy)
    {
      id = model.addPoint(model.points[std::size_t(id)] + offset);
    }
    model.addPolygon(copy);
  }
  model.forgetSolid();
}

/// A triangle that stands on an edge, outwards (a fin) or inwards (a wall).
void standOnEdge(Model& model, Random& random, double side)
{
  const Cell polygon = random.pick(model.polygons);
  const std::int64_t a = polygon[0], b = polygon[1];
  const Vec3 middle = 0.5 * (cornerOf(model, polygon, 0) + cornerOf(model, polygon, 1));
  const double size = random.logarithmic(0.01, 0.5) * radiusOf(model);
  model.addPolygon({ a, b, model.addPoint(middle + side * size * unitNormalOf(model, polygon)) });
  model.forgetSolid(); // on a concave edge it may reach anywhere
}

void addFin(Model& model, Random& random)
{
  standOnEdge(model, random, 1.0);
}

void addWall(Model& model, Random& random)
{
  standOnEdge(model, random, -1.0);
}

/// A membrane through the whole model.
void addMembrane(Model& model, Random& random)
{
  const Vec3 centre = centreOf(model);
  const double size = random.real(0.1, 1.5) * radiusOf(model);
  const Vec3 u = size * random.direction();
  const Vec3 v = size * random.direction();
  model.addPolygon({ model.addPoint(centre - u - v), model.addPoint(centre + u - v),
    model.addPoint(centre + u + v), model.addPoint(centre - u + v) });
  model.forgetSolid();
}

void addStrayTriangles(Model& model, Random& random)
{
  const int count = random.integer(1, 5);
  const Vec3 centre = centreOf(model);
  const double radius = radiusOf(model);
  for (int k = 0; k < count; ++k)
  {
    const Vec3 place = centre + random.real(1.5, 3.0) * radius * random.direction();
    const double size = random.logarithmic(1e-6, 0.3) * radius;
    model.addPolygon({ model.addPoint(place + size * random.direction()),
      model.addPoint(place + size * random.direction()),
      model.addPoint(place + size * random.direction()) });
  }
  model.forgetSolid();
}

void addStrayPart(Model& model, Random& random)
{
  const double radius = radiusOf(model);
  append(icosphere(random.integer(0, 1), random.logarithmic(1e-4, 0.3) * radius,
           centreOf(model) + 1.5 * radius * random.direction()),
    model);
  model.forgetSolid();
}

/// The same model again, moved a little: everything intersects everything.
void overlapWithItself(Model& model, Random& random)
{
  Model copy;
  copy.points = model.points;
  copy.polygons = model.polygons;
  const Vec3 offset = random.logarithmic(1e-9, 1.0) * radiusOf(model) * random.direction();
  for (Vec3& point : copy.points)
  {
    point += offset;
  }
  append(copy, model);
  model.forgetSolid();
}

/// Pulls a point through the model to the other side.
void pullThrough(Model& model, Random& random)
{
  const Vec3 centre = centreOf(model);
  Vec3& point = model.points[random.index(model.points.size())];
  point = centre - random.real(0.5, 2.0) * (point - centre);
  model.forgetSolid();
}

void addLinesAndVertices(Model& model, Random& random)
{
  const int count = random.integer(1, 10);
  for (int k = 0; k < count; ++k)
  {
    model.lines.push_back({ std::int64_t(random.index(model.points.size())),
      std::int64_t(random.index(model.points.size())) });
    model.vertices.push_back({ std::int64_t(random.index(model.points.size())) });
  }
  model.isClean = false;
}

} // namespace

const std::vector<Defect>& partDefects()
{
  static const std::vector<Defect> defects{ { "sheets", addSheets }, { "fin", addFin },
    { "wall", addWall }, { "membrane", addMembrane }, { "stray triangles", addStrayTriangles },
    { "stray part", addStrayPart }, { "overlapping copy", overlapWithItself },
    { "pulled through", pullThrough }, { "lines and vertices", addLinesAndVertices } };
  return defects;
}

} // namespace robustness
