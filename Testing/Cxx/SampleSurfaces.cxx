// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SampleSurfaces.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIcosphereSource.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Sample
{

namespace
{

//------------------------------------------------------------------------------
Surface FromSource(int shape, int level, int resolution, double radius, const Point& center)
{
  vtkNew<vtkIcosphereSource> source;
  source->SetShape(shape);
  source->SetLevel(level);
  source->SetResolution(resolution);
  source->SetRadius(radius);
  source->SetCenter(center[0], center[1], center[2]);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

//------------------------------------------------------------------------------
template <typename Reader>
Surface ReadWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

} // namespace

//------------------------------------------------------------------------------
Surface Make(const std::vector<Point>& points, const std::vector<Polygon>& polygons, int type)
{
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataType(type);
  for (const Point& point : points)
  {
    coordinates->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const Polygon& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  auto surface = Surface::New();
  surface->SetPoints(coordinates);
  surface->SetPolys(cells);
  return surface;
}

//------------------------------------------------------------------------------
Surface Icosphere(int level, double radius, const Point& center)
{
  return FromSource(vtkIcosphereSource::ICOSPHERE, level, 1, radius, center);
}

//------------------------------------------------------------------------------
Surface CubeSphere(int resolution, double radius)
{
  return FromSource(vtkIcosphereSource::CUBE_SPHERE, 0, resolution, radius, {});
}

//------------------------------------------------------------------------------
Surface Box(int resolution)
{
  return FromSource(vtkIcosphereSource::BOX, 0, resolution, 1.0, {});
}

//------------------------------------------------------------------------------
Surface Sheet(int n)
{
  std::vector<Point> points;
  std::vector<Polygon> triangles;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points.push_back({ 2.0 * i / n - 1.0, 2.0 * j / n - 1.0, 0.0 });
      if (i < n && j < n)
      {
        const vtkIdType a = j * (n + 1) + i;
        triangles.push_back({ a, a + 1, a + n + 2 });
        triangles.push_back({ a, a + n + 2, a + n + 1 });
      }
    }
  }
  return Make(points, triangles);
}

//------------------------------------------------------------------------------
Surface Moebius(int n)
{
  constexpr double Pi = 3.141592653589793;
  std::vector<Point> points;
  std::vector<Polygon> quads;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2.0 * Pi * i / n;
    for (const double side : { -0.3, 0.3 })
    {
      const double radius = 1.0 + side * std::cos(angle / 2.0);
      points.push_back(
        { radius * std::cos(angle), radius * std::sin(angle), side * std::sin(angle / 2.0) });
    }
    const vtkIdType a = 2 * i;
    // The last quad meets the first with its sides exchanged.
    const bool closes = i + 1 == n;
    quads.push_back({ a, a + 1, closes ? 0 : a + 3, closes ? 1 : a + 2 });
  }
  return Make(points, quads);
}

//------------------------------------------------------------------------------
Surface Octahedron(double radius)
{
  const double r = radius;
  return Make({ { r, 0, 0 }, { -r, 0, 0 }, { 0, r, 0 }, { 0, -r, 0 }, { 0, 0, r }, { 0, 0, -r } },
    { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 },
      { 0, 3, 5 } });
}

//------------------------------------------------------------------------------
Surface Read(const std::string& name)
{
  const std::string path = std::string(EVOLVINGSURFACES_DATA_DIR) + "/" + name;
  if (EndsWith(name, ".ply"))
  {
    return ReadWith<vtkPLYReader>(path);
  }
  return EndsWith(name, ".obj") ? ReadWith<vtkOBJReader>(path) : ReadWith<vtkPolyDataReader>(path);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> SphereImage(int n, double size, double radius)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const double spacing = 2.0 * size / (n - 1);
  image->SetDimensions(n, n, n);
  image->SetOrigin(-size, -size, -size);
  image->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkFloatArray> distance;
  distance->SetName("Distance");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    distance->InsertNextValue(static_cast<float>(std::hypot(p[0], p[1], p[2]) - radius));
  }
  image->GetPointData()->SetScalars(distance);
  return image;
}

//------------------------------------------------------------------------------
Polygon PolygonOf(vtkPolyData* surface, vtkIdType number)
{
  vtkNew<vtkIdList> ids;
  surface->GetPolys()->GetCellAtId(number, ids);
  return Polygon(ids->begin(), ids->end());
}

//------------------------------------------------------------------------------
std::vector<Polygon> PolygonsOf(vtkPolyData* surface)
{
  std::vector<Polygon> polygons;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    polygons.push_back(PolygonOf(surface, i));
  }
  return polygons;
}

//------------------------------------------------------------------------------
std::vector<Point> CoordinatesOf(vtkPolyData* surface)
{
  std::vector<Point> points(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    surface->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

} // namespace Sample
