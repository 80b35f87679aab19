// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CarriedArrays.h"

#include "ResultArrays.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <cstring>
#include <sstream>

namespace
{

using CarriedArrays::Attributes;

//------------------------------------------------------------------------------
bool IsTooShort(vtkAbstractArray* array, vtkIdType count)
{
  return array->GetNumberOfTuples() < count;
}

//------------------------------------------------------------------------------
/// The same arrays, without those that `isLeftOut` tells by their number.
template <typename Predicate>
Attributes Without(vtkDataSetAttributes* data, const Predicate& isLeftOut)
{
  const auto rest = vtk::TakeSmartPointer(data->NewInstance());
  rest->PassData(data);
  for (int i = rest->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (isLeftOut(rest, i))
    {
      rest->RemoveArray(i);
    }
  }
  return rest;
}

//------------------------------------------------------------------------------
Attributes Carried(vtkDataSetAttributes* data, vtkIdType count)
{
  return Without(data,
    [count](vtkDataSetAttributes* all, int i)
    {
      vtkAbstractArray* array = all->GetAbstractArray(i);
      const int role = all->IsArrayAnAttribute(i);
      return role == vtkDataSetAttributes::NORMALS || role == vtkDataSetAttributes::TANGENTS ||
        ResultArrays::IsResult(array) || count == 0 || IsTooShort(array, count);
    });
}

//------------------------------------------------------------------------------
bool IsContinuous(vtkDataSetAttributes* data, int number)
{
  vtkAbstractArray* array = data->GetAbstractArray(number);
  const int components = array->GetNumberOfComponents();
  const bool isColor =
    array->GetDataType() == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
  return isColor || array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
}

//------------------------------------------------------------------------------
void ListMisfits(
  vtkDataSetAttributes* data, vtkIdType count, const char* elements, std::ostream& list)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (IsTooShort(array, count))
    {
      list << " \"" << (array->GetName() ? array->GetName() : "") << "\" with "
           << array->GetNumberOfTuples() << " values for " << count << " " << elements << ",";
    }
  }
}

//------------------------------------------------------------------------------
std::string Misfits(vtkPolyData* input)
{
  std::ostringstream list;
  ListMisfits(input->GetPointData(), input->GetNumberOfPoints(), "points", list);
  ListMisfits(input->GetCellData(), input->GetNumberOfCells(), "cells", list);
  return list.str();
}

} // namespace

namespace CarriedArrays
{

//------------------------------------------------------------------------------
Attributes OfPoints(vtkPolyData* input)
{
  return Carried(input->GetPointData(), input->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
Attributes OfCells(vtkPolyData* input)
{
  return Carried(input->GetCellData(), input->GetNumberOfCells());
}

//------------------------------------------------------------------------------
bool HasAny(vtkPolyData* input)
{
  return OfPoints(input)->GetNumberOfArrays() + OfCells(input)->GetNumberOfArrays() > 0;
}

//------------------------------------------------------------------------------
Attributes WithoutIdentity(vtkDataSetAttributes* data)
{
  return Without(data,
    [](vtkDataSetAttributes* all, int i)
    {
      const int role = all->IsArrayAnAttribute(i);
      const char* name = all->GetAbstractArray(i)->GetName();
      return role == vtkDataSetAttributes::GLOBALIDS || role == vtkDataSetAttributes::PEDIGREEIDS ||
        (name && std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0);
    });
}

//------------------------------------------------------------------------------
Attributes Continuous(vtkDataSetAttributes* data)
{
  return Without(data, [](vtkDataSetAttributes* all, int i) { return !IsContinuous(all, i); });
}

//------------------------------------------------------------------------------
Attributes Discrete(vtkDataSetAttributes* data)
{
  return Without(data, IsContinuous);
}

//------------------------------------------------------------------------------
void RemoveNormals(vtkPolyData* output)
{
  const std::array<vtkDataSetAttributes*, 2> both = { output->GetPointData(),
    output->GetCellData() };
  for (vtkDataSetAttributes* data : both)
  {
    for (const int role : { vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::TANGENTS })
    {
      int numbers[vtkDataSetAttributes::NUM_ATTRIBUTES];
      data->GetAttributeIndices(numbers);
      if (numbers[role] != -1)
      {
        data->RemoveArray(numbers[role]);
      }
    }
  }
}

//------------------------------------------------------------------------------
void RenewNormals(vtkPolyData* input, vtkPolyData* output)
{
  if (input->GetPointData()->GetNormals())
  {
    output->GetPointData()->SetActiveNormals("Normals");
  }
}

} // namespace CarriedArrays

//------------------------------------------------------------------------------
void MisfitWarning::Say(vtkAlgorithm* filter, vtkPolyData* input)
{
  const std::string misfits = Misfits(input);
  if (!misfits.empty() && misfits != this->Said)
  {
    vtkWarningWithObjectMacro(
      filter, << "Arrays of the input are too short and were left out:" << misfits
              << " expected a value for each; check what produces them.");
  }
  this->Said = misfits;
}
