// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Defects.h"

#include "Mesh/FloatPoints.h"
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

namespace robustness
{

namespace
{

void addNoise(Model& model, Random& random)
{
  const double size = random.logarithmic(1e-9, 0.3) * radiusOf(model);
  for (Vec3& point : model.points)
  {
    point += size * random.real(0.0, 1.0) * random.direction();
  }
  model.forgetSolid();
}

void addUnusedPoints(Model& model, Random& random)
{
  const int count = random.integer(1, 5);
  const double radius = radiusOf(model);
  for (int k = 0; k < count; ++k)
  {
    model.addPoint(random.logarithmic(0.1, 1e6) * radius * random.direction());
  }
  model.isClean = false;
}

double notFinite(Random& random)
{
  const std::vector<double> values{ std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  return random.pick(values);
}

void addUnusedNaN(Model& model, Random& random)
{
  model.addPoint(Vec3(notFinite(random), 0.0, 0.0));
  model.isClean = false;
}

/// May be a point that no face uses.
void makeNaN(Model& model, Random& random)
{
  model.points[random.index(model.points.size())][random.integer(0, 2)] = notFinite(random);
  model.forgetSolid();
}

/// Point numbers that are not there: one too many, negative, or more than 32 bits.
void useWrongIds(Model& model, Random& random)
{
  const auto count = std::int64_t(model.points.size());
  const std::vector<std::int64_t> wrong{ count, -1, (std::int64_t(1) << 32) + 1,
    std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min() };
  if (random.chance(0.3))
  {
    model.strips.push_back(
      { 0, random.pick(wrong), std::int64_t(random.index(model.points.size())) });
  }
  else
  {
    model.addPolygon({ 0, 1, random.pick(wrong) });
  }
  model.forgetSolid();
}

/// A corner that comes twice, side by side or not.
void repeatIds(Model& model, Random& random)
{
  Cell& polygon = model.polygons[random.index(model.polygons.size())];
  const std::int64_t again = polygon[random.index(polygon.size())];
  const std::size_t place = random.index(polygon.size() + 1);
  polygon.insert(polygon.begin() + std::ptrdiff_t(place), again);
  model.forgetSolid();
}

/// Two points that are one, but not by number: folds faces together.
void weldTwoPoints(Model& model, Random& random)
{
  const Vec3 other = model.points[random.index(model.points.size())];
  model.points[random.index(model.points.size())] = other;
  model.forgetSolid();
}

void say(Model& model, const char* what, double value)
{
  std::ostringstream text;
  text << what << " " << value;
  model.story.push_back(text.str());
}

} // namespace

const std::vector<Defect>& pointDefects()
{
  static const std::vector<Defect> defects{ { "noise", addNoise },
    { "unused points", addUnusedPoints }, { "unused NaN", addUnusedNaN }, { "NaN", makeNaN },
    { "wrong ids", useWrongIds }, { "repeated ids", repeatIds },
    { "welded points", weldTwoPoints } };
  return defects;
}

void transform(Model& model, Random& random)
{
  double scale = 1.0;
  if (random.chance(0.25))
  {
    scale = random.logarithmic(1e-12, 1e12);
    say(model, "scale", scale);
  }
  Vec3 offset = Vec3::Zero();
  if (random.chance(0.25))
  {
    const double far = random.logarithmic(1.0, 1e8);
    offset = far * scale * random.direction();
    say(model, "offset", far);
  }
  model.isDouble = random.chance(0.5);
  for (Vec3& point : model.points)
  {
    point = scale * point + offset;
  }
  if (!model.isDouble)
  {
    model.points = evolving::roundedToFloats(std::move(model.points));
  }
}

} // namespace robustness
