// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Surface.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace robustness
{

namespace
{

std::vector<Cell> cellsOf(vtkCellArray* array)
{
  std::vector<Cell> cells;
  const auto place = vtk::TakeSmartPointer(array->NewIterator());
  for (place->GoToFirstCell(); !place->IsDoneWithTraversal(); place->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    place->GetCurrentCell(size, ids);
    cells.emplace_back(ids, ids + size);
  }
  return cells;
}

double angleAt(const Vec3& corner, const Vec3& next, const Vec3& last)
{
  const Vec3 a = next - corner;
  const Vec3 b = last - corner;
  const double sine = a.cross(b).norm();
  const double cosine = a.dot(b);
  constexpr double Degrees = 57.29577951308232;
  return sine == 0.0 && cosine == 0.0 ? 0.0 : Degrees * std::atan2(sine, cosine);
}

} // namespace

Surface surfaceOf(vtkPolyData* data)
{
  Surface surface;
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id)
  {
    Vec3 point;
    data->GetPoint(id, point.data());
    surface.points.push_back(point);
  }
  std::int64_t cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  for (const Cell& polygon : cellsOf(data->GetPolys()))
  {
    surface.faces.push_back(polygon);
    surface.cellOfFace.push_back(cell++);
  }
  for (const Cell& strip : cellsOf(data->GetStrips()))
  {
    for (std::size_t k = 0; k + 2 < strip.size(); ++k)
    {
      const std::size_t odd = k % 2;
      surface.faces.push_back({ strip[k], strip[k + 1 + odd], strip[k + 2 - odd] });
      surface.cellOfFace.push_back(cell);
    }
    ++cell;
  }
  return surface;
}

bool hasUsableFaces(const Surface& surface)
{
  const auto count = static_cast<std::int64_t>(surface.points.size());
  return std::all_of(surface.faces.begin(), surface.faces.end(),
    [count](const Cell& face)
    {
      return face.size() >= 3 &&
        std::all_of(
          face.begin(), face.end(), [count](std::int64_t id) { return id >= 0 && id < count; });
    });
}

bool hasFiniteCorners(const Surface& surface)
{
  return std::all_of(surface.faces.begin(), surface.faces.end(),
    [&](const Cell& face)
    {
      return std::all_of(face.begin(), face.end(),
        [&](std::int64_t id) { return surface.points[static_cast<std::size_t>(id)].allFinite(); });
    });
}

double smallestAngleOf(const Surface& surface)
{
  double smallest = surface.faces.empty() ? 0.0 : 180.0;
  for (const Cell& face : surface.faces)
  {
    const std::size_t n = face.size();
    for (std::size_t k = 0; k < n; ++k)
    {
      smallest = std::min(smallest,
        angleAt(surface.corner(face, k), surface.corner(face, (k + 1) % n),
          surface.corner(face, (k + n - 1) % n)));
    }
  }
  return smallest;
}

double areaOf(const Surface& surface)
{
  double area = 0.0;
  for (const Cell& face : surface.faces)
  {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
    {
      const Vec3& origin = surface.corner(face, 0);
      sum += 0.5 * (surface.corner(face, k) - origin).cross(surface.corner(face, k + 1) - origin);
    }
    area += sum.norm();
  }
  return area;
}

double volumeOf(const Surface& surface, const Vec3& centre)
{
  double volume = 0.0;
  for (const Cell& face : surface.faces)
  {
    // By edges: products of far corners would lose the volume of small parts.
    const Vec3 first = surface.corner(face, 0);
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
    {
      const Vec3 twiceArea =
        (surface.corner(face, k) - first).cross(surface.corner(face, k + 1) - first);
      volume += (first - centre).dot(twiceArea) / 6.0;
    }
  }
  return volume;
}

Vec3 middleOf(const Surface& surface)
{
  evolving::Box box;
  for (const Cell& face : surface.faces)
  {
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      box.extend(surface.corner(face, k));
    }
  }
  return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
}

double windingNumber(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const Vec3& place)
{
  double sum = 0.0;
  for (const Triangle& t : triangles)
  {
    const Vec3 a = points[static_cast<std::size_t>(t[0])] - place;
    const Vec3 b = points[static_cast<std::size_t>(t[1])] - place;
    const Vec3 c = points[static_cast<std::size_t>(t[2])] - place;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum +=
      std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / 6.283185307179586;
}

} // namespace robustness
