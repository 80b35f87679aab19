// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelOutput.h"

#include "ResultArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <utility>

namespace
{

//------------------------------------------------------------------------------
/// The background may be a label that the image has not, nor could have.
bool Holds(int type, double label)
{
  return label >= vtkDataArray::GetDataTypeMin(type) && label <= vtkDataArray::GetDataTypeMax(type);
}

} // namespace

//------------------------------------------------------------------------------
LabelOutput::LabelOutput(int type, double background, std::vector<double> values)
  : Type(Holds(type, background) ? type : VTK_DOUBLE)
  , Background(background)
  , Values(std::move(values))
{
}

//------------------------------------------------------------------------------
double LabelOutput::ValueOf(evolving::Material material) const
{
  return evolving::isLabel(material) ? this->Values[static_cast<std::size_t>(material) - 1]
                                     : this->Background;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> LabelOutput::MakeArray(
  const char* name, int components, vtkIdType count) const
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(this->Type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  return array;
}

//------------------------------------------------------------------------------
void LabelOutput::AddLabels(vtkPolyData* output, const char* name,
  const std::vector<evolving::Material>& materials, bool isActive) const
{
  const auto array = this->MakeArray(name, 1, static_cast<vtkIdType>(materials.size()));
  for (std::size_t i = 0; i < materials.size(); ++i)
  {
    array->SetComponent(static_cast<vtkIdType>(i), 0, this->ValueOf(materials[i]));
  }
  ResultArrays::Add(output->GetCellData(), array);
  if (isActive)
  {
    output->GetCellData()->SetActiveScalars(name);
  }
}

//------------------------------------------------------------------------------
void LabelOutput::AddField(
  vtkPolyData* output, const char* name, const std::vector<double>& values) const
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  ResultArrays::Add(output->GetFieldData(), array);
}

//------------------------------------------------------------------------------
void LabelOutput::WriteSurfaces(const evolving::LabelSurfaces& result, vtkPolyData* output) const
{
  KernelBridge::WritePoints(
    result.surfaces.points, result.pointsAreFloats ? VTK_FLOAT : VTK_DOUBLE, output);
  output->SetPolys(KernelBridge::WritePolygons(result.surfaces));
  this->AddLabels(output, "Label", result.labels, true);
  this->AddLabels(output, "NeighborLabel", result.others, false);
  this->AddField(output, "LabelValue", this->Values);
  this->AddField(output, "Volume", result.volumes);
  this->AddField(output, "VoxelVolume", result.voxelVolumes);
}

//------------------------------------------------------------------------------
void LabelOutput::WriteInterfaces(const evolving::LabelSurfaces& result, vtkPolyData* output) const
{
  KernelBridge::WritePoints(
    result.interfaces.points, result.pointsAreFloats ? VTK_FLOAT : VTK_DOUBLE, output);
  output->SetPolys(KernelBridge::WritePolygons(result.interfaces));
  const auto array =
    this->MakeArray("BoundaryLabels", 2, static_cast<vtkIdType>(result.sides.size()));
  for (std::size_t i = 0; i < result.sides.size(); ++i)
  {
    for (int side = 0; side < 2; ++side)
    {
      array->SetComponent(static_cast<vtkIdType>(i), side,
        this->ValueOf(result.sides[i][static_cast<std::size_t>(side)]));
    }
  }
  ResultArrays::Add(output->GetCellData(), array);
  output->GetCellData()->SetActiveScalars("BoundaryLabels");
}
