// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Models.h"

#include "Arguments.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCleanPolyData.h"
#include "vtkIcosphereSource.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyDataReader.h"
#include "vtkSTLReader.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataReader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace benchmark
{

namespace
{

template <typename Reader>
vtkSmartPointer<vtkPolyData> readWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

vtkSmartPointer<vtkPolyData> readByEnding(const std::string& path)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".obj")
  {
    return readWith<vtkOBJReader>(path);
  }
  if (ending == ".ply")
  {
    return readWith<vtkPLYReader>(path);
  }
  if (ending == ".stl")
  {
    return readWith<vtkSTLReader>(path);
  }
  if (ending == ".vtp")
  {
    return readWith<vtkXMLPolyDataReader>(path);
  }
  return readWith<vtkPolyDataReader>(path);
}

/// Readers split points at texture seams; subdivision would tear the surface open there.
vtkSmartPointer<vtkPolyData> weldedTriangles(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> bare; // without point data, which would be interpolated, too
  bare->SetPoints(surface->GetPoints());
  bare->SetPolys(surface->GetPolys());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(bare);
  clean->SetTolerance(0.0);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(clean->GetOutputPort());
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  return triangles->GetOutput();
}

/// Every subdivision makes four triangles of one.
int subdivisionsTowardsScan(vtkIdType triangles)
{
  constexpr double ScanTriangles = 80000.0;
  const double steps = std::log(ScanTriangles / static_cast<double>(triangles)) / std::log(4.0);
  return steps > 0.0 ? static_cast<int>(std::lround(steps)) : 0;
}

} // namespace

Model readModel(const std::string& path)
{
  Model model{ std::filesystem::path(path).filename().string(), readByEnding(path) };
  if (model.surface->GetNumberOfPoints() == 0)
  {
    std::cerr << "'" << path
              << "' has no points; expected a .obj, .ply, .stl, .vtk or .vtp mesh.\n";
    std::exit(2);
  }
  return model;
}

Model readScan(const std::string& path, int subdivisions)
{
  Model model = readModel(path);
  model.surface = weldedTriangles(model.surface);
  const int times = subdivisions == Arguments::Automatic
    ? subdivisionsTowardsScan(model.surface->GetNumberOfPolys())
    : subdivisions;
  if (times > 0)
  {
    vtkNew<vtkLoopSubdivisionFilter> loop;
    loop->SetInputData(model.surface);
    loop->SetNumberOfSubdivisions(times);
    loop->Update();
    model.surface = loop->GetOutput();
    model.name += " subdivided " + std::to_string(times) + (times == 1 ? " time" : " times");
  }
  model.name += ", " + std::to_string(model.triangles()) + " triangles";
  return model;
}

Model unitSphere(int size)
{
  // Level 7 does for 256^3; a level more brings the facets four times as near.
  const double level = 7.0 + std::log(size / 256.0) / std::log(4.0);
  vtkNew<vtkIcosphereSource> source;
  source->SetShape(vtkIcosphereSource::ICOSPHERE);
  source->SetLevel(std::max(0, static_cast<int>(std::ceil(level))));
  source->SetRadius(1.0);
  source->SetCenter(0.0, 0.0, 0.0);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return { "unit sphere", source->GetOutput() };
}

evolving::SurfaceMesh kernelMesh(vtkPolyData* surface)
{
  evolving::SurfaceMesh mesh;
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    double point[3];
    surface->GetPoint(p, point);
    mesh.addPoint({ point[0], point[1], point[2] });
  }
  vtkCellArray* cells = surface->GetPolys();
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(c, size, corners);
    mesh.addFace(std::vector<evolving::Index>(corners, corners + size));
  }
  return mesh;
}

} // namespace benchmark
