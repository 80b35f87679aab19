// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistanceReference.h"

#include "PolygonEars.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace robustness
{

namespace
{

using Long3 = Eigen::Matrix<long double, 3, 1>;
constexpr double Infinity = std::numeric_limits<double>::infinity();

long double squaredToSegment(const Long3& p, const Long3& a, const Long3& b)
{
  const Long3 along = b - a;
  const long double length = along.squaredNorm();
  const long double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0L, 1.0L) : 0.0L;
  return (p - a - t * along).squaredNorm();
}

/// Of the plane where the foot is inside the triangle, otherwise infinity.
long double squaredToInside(const Long3& p, const Long3& a, const Long3& b, const Long3& c)
{
  const Long3 normal = (b - a).cross(c - a);
  const long double squared = normal.squaredNorm();
  const bool isInside = squared > 0 && (b - a).cross(p - a).dot(normal) >= 0 &&
    (c - b).cross(p - b).dot(normal) >= 0 && (a - c).cross(p - c).dot(normal) >= 0;
  const long double height = normal.dot(p - a);
  return isInside ? height * height / squared : std::numeric_limits<long double>::infinity();
}

/// Polygons of more corners are boxed instead of cut in every way.
constexpr std::size_t MostCornersCut = 8;

} // namespace

double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  // From the point, so that nothing is lost far from the origin.
  const Long3 q = p.cast<long double>();
  const Long3 u = a.cast<long double>() - q;
  const Long3 v = b.cast<long double>() - q;
  const Long3 w = c.cast<long double>() - q;
  const Long3 zero = Long3::Zero();
  const long double squared = std::min({ squaredToSegment(zero, u, v), squaredToSegment(zero, v, w),
    squaredToSegment(zero, w, u), squaredToInside(zero, u, v, w) });
  return static_cast<double>(std::sqrt(squared));
}

DistanceReference::DistanceReference(vtkPolyData* data, bool allCount)
  : AllCount(allCount)
{
  if (data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0)
  {
    this->addFaces(surfaceOf(data));
  }
  else
  {
    this->addPoints(data);
  }
}

void DistanceReference::addTriangle(const Triangle& t, std::int64_t cell)
{
  const auto at = [&](std::size_t k) -> const Vec3&
  { return this->Points[static_cast<std::size_t>(t[k])]; };
  const bool usesPointTwice = at(0) == at(1) || at(1) == at(2) || at(2) == at(0);
  if (!usesPointTwice || this->OfPoints || this->AllCount)
  {
    this->Triangles.push_back(t);
    this->CellOfTriangle.push_back(cell);
  }
}

void DistanceReference::addFaces(const Surface& surface)
{
  this->Points = surface.points;
  for (std::size_t f = 0; f < surface.faces.size(); ++f)
  {
    const Cell& face = surface.faces[f];
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      this->Around.extend(surface.corner(face, k));
    }
    if (!isPlanarAndSimple(surface.points, face))
    {
      this->addLoosePolygon(face);
      continue;
    }
    for (const Triangle& ear : earsOf(surface.points, face))
    {
      this->addTriangle(ear, surface.cellOfFace[f]);
    }
  }
}

void DistanceReference::addPoints(vtkPolyData* data)
{
  this->OfPoints = true;
  this->Points = surfaceOf(data).points;
  const auto add = [this](std::int64_t id, std::int64_t cell)
  {
    this->Around.extend(this->Points[static_cast<std::size_t>(id)]);
    this->addTriangle({ id, id, id }, cell);
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfVerts(); ++cell)
  {
    data->GetVerts()->GetCellAtId(cell, ids);
    std::for_each(ids->begin(), ids->end(), [&](vtkIdType id) { add(id, cell); });
  }
  for (vtkIdType id = 0; data->GetNumberOfVerts() == 0 && id < data->GetNumberOfPoints(); ++id)
  {
    add(id, id);
  }
}

void DistanceReference::addLoosePolygon(const Cell& polygon)
{
  const std::size_t n = polygon.size();
  evolving::Box box;
  const Surface alone = welded({ this->Points, { polygon }, { 0 } });
  const bool hasAllCorners = !alone.faces.empty() && alone.faces.front().size() == n;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::int64_t next = polygon[(i + 1) % n];
    box.extend(this->Points[static_cast<std::size_t>(polygon[i])]);
    if (hasAllCorners)
    {
      this->Sure.push_back({ polygon[i], next, next });
    }
    for (std::size_t j = i + 1; j < n && n <= MostCornersCut; ++j)
    {
      for (std::size_t k = j + 1; k < n; ++k)
      {
        this->Possible.push_back({ polygon[i], polygon[j], polygon[k] });
      }
    }
  }
  this->IsLoose = true;
  if (n > MostCornersCut)
  {
    this->Boxes.push_back(box);
  }
}

double DistanceReference::toAll(const Vec3& place, const std::vector<Triangle>& triangles) const
{
  double least = Infinity;
  for (const Triangle& t : triangles)
  {
    const auto at = [&](std::size_t k) -> const Vec3&
    { return this->Points[static_cast<std::size_t>(t[k])]; };
    least = std::min(least, distanceToTriangle(place, at(0), at(1), at(2)));
  }
  return least;
}

DistanceBounds DistanceReference::operator()(const Vec3& place) const
{
  const double known = this->toAll(place, this->Triangles);
  if (!this->IsLoose)
  {
    return { known, known };
  }
  double lower = std::min(known, this->toAll(place, this->Possible));
  for (const evolving::Box& box : this->Boxes)
  {
    lower = std::min(lower, box.exteriorDistance(place));
  }
  return { lower, std::min(known, this->toAll(place, this->Sure)) };
}

double DistanceReference::toCell(const Vec3& place, std::int64_t cell) const
{
  double distance = Infinity;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (this->CellOfTriangle[t] == cell)
    {
      const auto at = [&](std::size_t k) -> const Vec3&
      { return this->Points[static_cast<std::size_t>(this->Triangles[t][k])]; };
      distance = std::min(distance, distanceToTriangle(place, at(0), at(1), at(2)));
    }
  }
  return distance;
}

} // namespace robustness
