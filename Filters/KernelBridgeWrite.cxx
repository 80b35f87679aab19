// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "ResultArrays.h"

#include "vtkAlgorithm.h"
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

namespace KernelBridge
{

namespace
{

//------------------------------------------------------------------------------
void AddFieldArray(vtkDataObject* data, vtkAbstractArray* array)
{
  if (!data->GetFieldData())
  {
    data->SetFieldData(vtkNew<vtkFieldData>());
  }
  ResultArrays::Add(data->GetFieldData(), array);
}

} // namespace

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
int PointType(vtkPointSet* input)
{
  const bool isDouble =
    input && input->GetPoints() && input->GetPoints()->GetDataType() == VTK_DOUBLE;
  return isDouble ? VTK_DOUBLE : VTK_FLOAT;
}

//------------------------------------------------------------------------------
void WarnOfDoubles(vtkAlgorithm* filter)
{
  vtkWarningWithObjectMacro(filter,
    << "The points of the output are double although those of the input are float: rounded to "
       "float, "
       "elements as small as these would lose their shapes or run through each other; larger ones, "
       "or an input nearer to the origin, keep float.");
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
  ResultArrays::Add(data->GetPointData(), array);
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
  ResultArrays::Add(data->GetPointData(), array);
}

//------------------------------------------------------------------------------
void AddFieldValue(vtkDataObject* data, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  AddFieldArray(data, array);
}

//------------------------------------------------------------------------------
void AddFieldValue(vtkDataObject* data, const char* name, int value)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  AddFieldArray(data, array);
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
  AddFieldArray(data, array);
}

} // namespace KernelBridge
