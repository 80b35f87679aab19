// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "RedistributionJudge.h"

#include "DistanceReference.h"
#include "OutputChecks.h"
#include "Verdict.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace robustness
{

namespace
{

/// Points with the coordinates of used ones go with them.
void addTwins(const Surface& surface, std::vector<char>& used)
{
  const auto placeOf = [&](std::size_t i) -> std::array<double, 3> {
    return { surface.points[i].x(), surface.points[i].y(), surface.points[i].z() };
  };
  std::set<std::array<double, 3>> places;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      places.insert(placeOf(i));
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    used[i] = used[i] || (surface.points[i].allFinite() && places.count(placeOf(i)) > 0);
  }
}

std::vector<char> usedPoints(const Surface& surface)
{
  std::vector<char> used(surface.points.size(), 0);
  for (const Cell& face : surface.faces)
  {
    for (const std::int64_t id : face)
    {
      used[static_cast<std::size_t>(id)] = 1;
    }
  }
  addTwins(surface, used);
  return used;
}

/// The welded places of a surface's border.
std::vector<Vec3> borderPlaces(const Surface& joined)
{
  std::map<std::pair<std::int64_t, std::int64_t>, int> uses;
  for (const Cell& face : joined.faces)
  {
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      ++uses[std::minmax(face[k], face[(k + 1) % face.size()])];
    }
  }
  std::vector<Vec3> places;
  for (const auto& [edge, count] : uses)
  {
    if (count == 1)
    {
      places.push_back(joined.points[static_cast<std::size_t>(edge.first)]);
      places.push_back(joined.points[static_cast<std::size_t>(edge.second)]);
    }
  }
  return places;
}

/// Both NaN, or the same number.
bool areSame(const Vec3& a, const Vec3& b)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(a[axis] == b[axis] || (std::isnan(a[axis]) && std::isnan(b[axis]))))
    {
      return false;
    }
  }
  return true;
}

void requireOnSurface(const Subject& input, const std::vector<char>& used, const Surface& output)
{
  const constexpr bool AllFacesCount = true; // also those that use a point twice
  const DistanceReference reference(input.data, AllFacesCount);
  // Points are written as the input's, floats maybe.
  const double rounding =
    (input.model.isDouble ? 1e-9 : 2e-7) * input.centre.norm() + 1e-6 * input.radius;
  const std::size_t step = 1 + output.points.size() * reference.size() / 4000000;
  for (std::size_t i = 0; i < output.points.size(); i += step)
  {
    const double away = used[i] ? reference(output.points[i]).lower : 0.0;
    require(away <= rounding, Fault::TooFar, "point ", i, " is ", away,
      " away from the input's surface of radius ", input.radius);
  }
}

} // namespace

void judgeRedistribution(
  const Subject& input, const RedistributionPromises& promises, vtkPolyData* data)
{
  const Surface output = surfaceOf(data);
  require(output.faces == input.surface.faces &&
      data->GetNumberOfCells() == input.data->GetNumberOfCells() &&
      output.points.size() == input.surface.points.size(),
    Fault::ChangedInput, "cells or ids are not those of the input");
  const std::vector<char> used = usedPoints(input.surface);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    require(
      used[i] ? output.points[i].allFinite() : areSame(output.points[i], input.surface.points[i]),
      used[i] ? Fault::NotFinite : Fault::ChangedInput, "point ", i, " is at (",
      output.points[i].transpose(), ")");
  }
  for (const char* name : { "MeanCurvature", "CoVolume", "RedistributionPotential" })
  {
    pointArray(data, name, 1);
  }
  if (promises.keepsShape)
  {
    requireOnSurface(input, used, output);
  }
  const std::vector<Vec3> before =
    promises.keepsBorder ? borderPlaces(input.joined) : std::vector<Vec3>();
  for (const Vec3& place : before)
  {
    require(std::any_of(output.points.begin(), output.points.end(),
              [&](const Vec3& point) { return point == place; }),
      Fault::ChangedInput, "the border point (", place.transpose(), ") has moved");
  }
}

} // namespace robustness
