// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SpecialModels.h"

namespace robustness
{

namespace
{

Model makeNothing(Random&)
{
  return {};
}

Model makeOnePoint(Random& random)
{
  Model model;
  model.addPoint(random.direction());
  if (random.chance(0.5))
  {
    model.vertices.push_back({ 0 });
  }
  return model;
}

Model makeOneTriangle(Random& random)
{
  Model model;
  for (int k = 0; k < 3; ++k)
  {
    model.addPoint(random.direction());
  }
  model.addPolygon({ 0, 1, 2 });
  return model;
}

Model makeNeedle(Random& random)
{
  Model model;
  model.points = { { 0, 0, 0 }, { random.logarithmic(1e-15, 1e-3), 0, 0 },
    { 0, random.logarithmic(1e-3, 1.0), 0 } };
  model.addPolygon({ 0, 1, 2 });
  return model;
}

/// Triangles between random ones of some points.
Model connect(Model model, int faces, Random& random)
{
  for (int f = 0; f < faces; ++f)
  {
    const auto id = [&]() { return std::int64_t(random.index(model.points.size())); };
    model.addPolygon({ id(), id(), id() });
  }
  return model;
}

Model makeCollinear(Random& random)
{
  Model model;
  const Vec3 along = random.chance(0.5) ? Vec3(1.0, 0.0, 0.0) : random.direction();
  const int count = random.integer(3, 20);
  for (int k = 0; k < count; ++k)
  {
    model.addPoint(random.integer(0, 8) / 8.0 * along);
  }
  return connect(model, random.integer(1, 20), random);
}

Model makeNoAreas(Random& random)
{
  Model model = connect(makeOneTriangle(random), 0, random);
  model.polygons.clear();
  const std::int64_t twin = model.addPoint(Vec3(model.points[1]));
  model.addPolygon({ 0, 1, random.chance(0.5) ? 1 : twin });
  return model;
}

Model makeCoplanar(Random& random)
{
  Model model;
  const Vec3 u = random.chance(0.5) ? Vec3(1.0, 0.0, 0.0) : random.direction();
  const Vec3 v = random.chance(0.5) ? Vec3(0.0, 1.0, 0.0) : random.direction();
  const int count = random.integer(3, 30);
  for (int k = 0; k < count; ++k)
  {
    model.addPoint(random.integer(0, 4) * u + random.integer(0, 4) * v);
  }
  return connect(model, random.integer(1, 40), random);
}

Model makeSoup(Random& random)
{
  Model model;
  const int faces = random.integer(2, 300);
  const double size = random.logarithmic(0.01, 2.0);
  for (int f = 0; f < faces; ++f)
  {
    const Vec3 place = random.real(0.0, 1.0) * random.direction();
    Cell polygon;
    for (int k = 0; k < 3; ++k)
    {
      polygon.push_back(model.addPoint(place + size * random.direction()));
    }
    model.addPolygon(polygon);
  }
  return model;
}

Model makeRandomConnections(Random& random)
{
  Model model;
  const int count = random.integer(3, 60);
  for (int k = 0; k < count; ++k)
  {
    model.addPoint(random.direction());
  }
  return connect(model, random.integer(1, 150), random);
}

Model makeTwoFaces(Random& random)
{
  Model model = makeOneTriangle(random);
  model.addPolygon(random.chance(0.5) ? Cell{ 0, 2, 1 } : Cell{ 0, 1, 2 });
  return model;
}

/// Points of every count, and as often one more than a multiple of eight: trees of eight boxes.
int pointCount(Random& random)
{
  return random.chance(0.5) ? 8 * random.integer(0, 40) + 1 : random.integer(1, 400);
}

Model makePointSet(Random& random)
{
  Model model;
  const int count = pointCount(random);
  const int kind = random.integer(0, 3);
  for (int k = 0; k < count; ++k)
  {
    const std::vector<Vec3> places{ random.real(0.0, 1.0) * random.direction(), random.direction(),
      Vec3(k % 5, k / 5 % 5, k / 25), Vec3(0.1 * k, 0.0, 0.0) };
    model.addPoint(places[std::size_t(kind)]);
  }
  if (random.chance(0.3))
  {
    for (std::int64_t k = 0; k < count; ++k)
    {
      model.vertices.push_back({ k });
    }
  }
  return model;
}

Model makeOneVertexCell(Random& random)
{
  Model model = makePointSet(random);
  model.vertices.assign(1, Cell());
  for (std::size_t k = 0; k < model.points.size(); ++k)
  {
    model.vertices.front().push_back(std::int64_t(k));
  }
  return model;
}

Model makeCoincidentPoints(Random& random)
{
  Model model;
  model.points.assign(std::size_t(pointCount(random)), random.direction());
  return model;
}

Model makeLines(Random& random)
{
  Model model;
  const int count = random.integer(2, 40);
  for (std::int64_t k = 0; k < count; ++k)
  {
    model.addPoint(random.direction());
    model.lines.push_back({ k, (k + 1) % count });
  }
  return model;
}

} // namespace

const std::vector<BaseShape>& specialModels()
{
  static const std::vector<BaseShape> models{ { "nothing", makeNothing },
    { "one point", makeOnePoint }, { "one triangle", makeOneTriangle }, { "needle", makeNeedle },
    { "collinear", makeCollinear }, { "no areas", makeNoAreas }, { "coplanar", makeCoplanar },
    { "soup of triangles", makeSoup }, { "random connections", makeRandomConnections },
    { "two faces", makeTwoFaces }, { "point set", makePointSet },
    { "one vertex cell", makeOneVertexCell }, { "coincident points", makeCoincidentPoints },
    { "lines", makeLines } };
  return models;
}

} // namespace robustness
