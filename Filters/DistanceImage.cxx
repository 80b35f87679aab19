// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DistanceImage.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>

namespace DistanceImage
{

namespace
{

//------------------------------------------------------------------------------
void AddFloatArray(
  vtkImageData* image, const char* name, int components, const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  image->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
void AddClosestCells(vtkImageData* image, const std::vector<evolving::Index>& faces,
  const std::vector<vtkIdType>& cellOfFace)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName("ClosestCellId");
  array->SetNumberOfTuples(static_cast<vtkIdType>(faces.size()));
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const evolving::Index face = faces[i];
    array->SetValue(static_cast<vtkIdType>(i),
      face == evolving::NoIndex ? -1 : cellOfFace[static_cast<std::size_t>(face)]);
  }
  image->GetPointData()->AddArray(array);
}

} // namespace

//------------------------------------------------------------------------------
void Write(const evolving::DistanceGrid& grid, const evolving::Extent& part,
  const evolving::SignedDistanceResult& result, const std::vector<vtkIdType>& cellOfFace,
  vtkImageData* output)
{
  output->SetOrigin(grid.origin.data());
  output->SetSpacing(grid.spacing.data());
  output->SetExtent(part[0], part[1], part[2], part[3], part[4], part[5]);
  AddFloatArray(output, "SignedDistance", 1, result.distance);
  output->GetPointData()->SetActiveScalars("SignedDistance");
  if (!result.closestPoint.empty())
  {
    AddFloatArray(output, "ClosestPoint", 3, result.closestPoint);
  }
  if (!result.closestFace.empty())
  {
    AddClosestCells(output, result.closestFace, cellOfFace);
  }
  if (!result.gradient.empty())
  {
    AddFloatArray(output, "Gradient", 3, result.gradient);
  }
  KernelBridge::AddFieldValue(output, "SignMethod", static_cast<int>(result.sign));
  KernelBridge::AddFieldValue(output, "SignReason", result.signReason);
}

} // namespace DistanceImage
