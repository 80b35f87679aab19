// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <type_traits>

namespace KernelBridge
{

namespace
{

//------------------------------------------------------------------------------
void ReplaceFieldArray(vtkDataObject* data, vtkAbstractArray* array)
{
  if (!data->GetFieldData())
  {
    data->SetFieldData(vtkNew<vtkFieldData>());
  }
  data->GetFieldData()->AddArray(array);
}

} // namespace

//------------------------------------------------------------------------------
void MoveWeldedPoints(
  const WeldedSurface& surface, const std::vector<evolving::Vec3>& points, vtkPolyData* output)
{
  vtkNew<vtkPoints> moved;
  moved->SetDataType(output->GetPoints()->GetDataType());
  moved->DeepCopy(output->GetPoints());
  for (std::size_t i = 0; i < surface.vertexOfPoint.size(); ++i)
  {
    const evolving::Index vertex = surface.vertexOfPoint[i];
    if (vertex != evolving::NoIndex)
    {
      moved->SetPoint(static_cast<vtkIdType>(i), points[static_cast<std::size_t>(vertex)].data());
    }
  }
  output->SetPoints(moved);
}

//------------------------------------------------------------------------------
evolving::StateArrays Unweld(const WeldedSurface& surface, const evolving::StateArrays& arrays)
{
  const auto spread = [&surface](const auto& values, const auto& zero)
  {
    using Values = std::decay_t<decltype(values)>;
    Values spreadValues;
    for (const evolving::Index vertex : surface.vertexOfPoint)
    {
      const bool has = vertex != evolving::NoIndex && !values.empty();
      spreadValues.push_back(has ? values[static_cast<std::size_t>(vertex)] : zero);
    }
    return spreadValues;
  };
  const evolving::Vec3 zero = evolving::Vec3::Zero();
  evolving::StateArrays points;
  points.normal = spread(arrays.normal, zero);
  points.meanCurvature = spread(arrays.meanCurvature, 0.0);
  points.coVolume = spread(arrays.coVolume, 0.0);
  points.tangentialVelocity = spread(arrays.tangentialVelocity, zero);
  points.redistributionPotential = spread(arrays.redistributionPotential, 0.0);
  return points;
}

//------------------------------------------------------------------------------
void CopyWithoutTuples(vtkPolyData* input, vtkPolyData* output)
{
  output->Initialize();
  if (input)
  {
    // Global ids too, which VTK copies only where it is told that they stay true.
    output->GetPointData()->CopyAllOn();
    output->GetPointData()->CopyAllocate(input->GetPointData());
    output->GetCellData()->CopyAllOn();
    output->GetCellData()->CopyAllocate(input->GetCellData());
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WritePolyData(const evolving::SurfaceMesh& mesh, int pointType)
{
  const auto output = vtkSmartPointer<vtkPolyData>::New();
  WritePoints(mesh.points, pointType, output);
  output->SetPolys(WritePolygons(mesh));
  return output;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> WritePolygons(const evolving::SurfaceMesh& mesh)
{
  const auto polygons = vtkSmartPointer<vtkCellArray>::New();
  polygons->AllocateEstimate(mesh.faceCount(), 3);
  std::vector<vtkIdType> ids;
  for (evolving::Index face = 0; face < mesh.faceCount(); ++face)
  {
    ids.clear();
    for (evolving::Index k = 0; k < mesh.faceSize(face); ++k)
    {
      ids.push_back(mesh.faceVertex(face, k));
    }
    polygons->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return polygons;
}

//------------------------------------------------------------------------------
void WritePoints(const std::vector<evolving::Vec3>& points, int pointType, vtkPolyData* output)
{
  vtkNew<vtkPoints> written;
  written->SetDataType(pointType);
  written->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    written->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  output->SetPoints(written);
}

//------------------------------------------------------------------------------
void RoundPoints(int pointType, std::vector<evolving::Vec3>& points)
{
  for (evolving::Vec3& point : points)
  {
    point = pointType == VTK_FLOAT ? evolving::Vec3(point.cast<float>().cast<double>()) : point;
  }
}

//------------------------------------------------------------------------------
void AddPointArray(vtkDataSet* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  data->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
void AddPointArray(vtkDataSet* data, const char* name, const std::vector<evolving::Vec3>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i), values[i].data());
  }
  data->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
void AddFieldValue(vtkDataObject* data, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  ReplaceFieldArray(data, array);
}

//------------------------------------------------------------------------------
void AddFieldValue(vtkDataObject* data, const char* name, int value)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  ReplaceFieldArray(data, array);
}

//------------------------------------------------------------------------------
void AddFieldValue(vtkDataObject* data, const char* name, const std::string& value)
{
  AddFieldStrings(data, name, { value });
}

//------------------------------------------------------------------------------
void AddFieldStrings(vtkDataObject* data, const char* name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  ReplaceFieldArray(data, array);
}

} // namespace KernelBridge
