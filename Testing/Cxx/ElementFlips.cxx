// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ElementFlips.h"

#include "SampleSurfaces.h"

#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkVector.h"
#include "vtkVectorOperators.h"

#include <cmath>
#include <vector>

namespace
{

//------------------------------------------------------------------------------
/// Point k of a polygon, counted around.
vtkVector3d Corner(vtkPolyData* surface, const Sample::Polygon& polygon, std::size_t k)
{
  vtkVector3d point;
  surface->GetPoint(polygon[k % polygon.size()], point.GetData());
  return point;
}

//------------------------------------------------------------------------------
/// Twice the area, along the normal.
vtkVector3d AreaNormal(vtkPolyData* surface, const Sample::Polygon& polygon)
{
  vtkVector3d sum(0.0);
  const vtkVector3d origin = Corner(surface, polygon, 0);
  for (std::size_t k = 2; k < polygon.size(); ++k)
  {
    sum =
      sum + (Corner(surface, polygon, k - 1) - origin).Cross(Corner(surface, polygon, k) - origin);
  }
  return sum;
}

//------------------------------------------------------------------------------
std::vector<vtkVector3d> PointNormals(
  vtkPolyData* surface, const std::vector<Sample::Polygon>& polygons)
{
  std::vector<vtkVector3d> normals(
    static_cast<std::size_t>(surface->GetNumberOfPoints()), vtkVector3d(0.0));
  for (const Sample::Polygon& polygon : polygons)
  {
    const vtkVector3d normal = AreaNormal(surface, polygon).Normalized();
    for (std::size_t k = 0; k < polygon.size(); ++k)
    {
      const vtkVector3d point = Corner(surface, polygon, k);
      const vtkVector3d next = Corner(surface, polygon, k + 1) - point;
      const vtkVector3d last = Corner(surface, polygon, k + polygon.size() - 1) - point;
      const double angle = std::atan2(next.Cross(last).Norm(), next.Dot(last));
      vtkVector3d& sum = normals[static_cast<std::size_t>(polygon[k])];
      sum = sum + angle * normal;
    }
  }
  for (vtkVector3d& normal : normals)
  {
    normal.Normalize();
  }
  return normals;
}

} // namespace

//------------------------------------------------------------------------------
vtkIdType CountFolded(vtkPolyData* surface)
{
  const std::vector<Sample::Polygon> polygons = Sample::PolygonsOf(surface);
  const std::vector<vtkVector3d> normals = PointNormals(surface, polygons);
  vtkIdType count = 0;
  for (const Sample::Polygon& polygon : polygons)
  {
    vtkVector3d sum(0.0);
    for (const vtkIdType point : polygon)
    {
      sum = sum + normals[static_cast<std::size_t>(point)];
    }
    count += AreaNormal(surface, polygon).Dot(sum) > 0.0 ? 0 : 1;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkIdType CountTurned(vtkPolyData* before, vtkPolyData* after)
{
  vtkIdType count = 0;
  for (const Sample::Polygon& polygon : Sample::PolygonsOf(before))
  {
    count += AreaNormal(before, polygon).Dot(AreaNormal(after, polygon)) > 0.0 ? 0 : 1;
  }
  return count;
}
