// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ResultArrays.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkSmartPointer.h"

#include <string>

namespace ResultArrays
{

namespace
{

/**
 * The value of vtkDataObject::FIELD_NAME() in a result's information. A key of VTK's own: one of
 * this module would make readers of files warn wherever the module is not loaded.
 */
constexpr const char* Mark = "EvolvingSurfaces";

//------------------------------------------------------------------------------
/// The array itself is the input's, too, and keeps its name there.
vtkSmartPointer<vtkAbstractArray> CopyNamed(vtkAbstractArray* array, const std::string& name)
{
  const auto copy = vtk::TakeSmartPointer(array->NewInstance());
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (numbers)
  {
    vtkDataArray::SafeDownCast(copy)->ShallowCopy(numbers);
  }
  else
  {
    copy->DeepCopy(array);
  }
  copy->SetName(name.c_str());
  return copy;
}

//------------------------------------------------------------------------------
std::string FreeName(vtkFieldData* data, const std::string& taken)
{
  std::string name = taken + "_input";
  while (data->HasArray(name.c_str()))
  {
    name += "_input";
  }
  return name;
}

//------------------------------------------------------------------------------
void Rename(vtkFieldData* data, int number)
{
  auto* attributes = vtkDataSetAttributes::SafeDownCast(data);
  const int role = attributes ? attributes->IsArrayAnAttribute(number) : -1;
  vtkAbstractArray* array = data->GetAbstractArray(number);
  const auto renamed = CopyNamed(array, FreeName(data, array->GetName()));
  data->RemoveArray(number);
  const int newNumber = data->AddArray(renamed);
  if (role != -1)
  {
    attributes->SetActiveAttribute(newNumber, role);
  }
}

} // namespace

//------------------------------------------------------------------------------
void Add(vtkFieldData* data, vtkAbstractArray* result)
{
  int number = -1;
  vtkAbstractArray* old = data->GetAbstractArray(result->GetName(), number);
  if (old && !IsResult(old))
  {
    Rename(data, number);
  }
  result->GetInformation()->Set(vtkDataObject::FIELD_NAME(), Mark);
  data->AddArray(result);
}

//------------------------------------------------------------------------------
bool IsResult(vtkAbstractArray* array)
{
  const char* mark =
    array->HasInformation() ? array->GetInformation()->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  return mark && std::string(mark) == Mark;
}

//------------------------------------------------------------------------------
void Remove(vtkFieldData* data)
{
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (IsResult(data->GetAbstractArray(i)))
    {
      data->RemoveArray(i);
    }
  }
}

} // namespace ResultArrays
