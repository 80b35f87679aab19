// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DressedSurfaces.h"

#include "vtkBitArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>

namespace
{

constexpr double HalfOfColors = 127.5;

//------------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<Array> Made(const char* name, int components = 1)
{
  const auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkIdTypeArray> NumbersFrom(const char* name, vtkIdType first, vtkIdType count)
{
  const auto array = Made<vtkIdTypeArray>(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->InsertNextValue(first + i);
  }
  return array;
}

//------------------------------------------------------------------------------
Sample::Point MiddleOf(vtkPolyData* surface, vtkIdType cell)
{
  Sample::Point middle = { 0.0, 0.0, 0.0 };
  const Sample::Polygon corners = Sample::PolygonOf(surface, cell);
  for (const vtkIdType corner : corners)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      middle[axis] += surface->GetPoint(corner)[axis] / static_cast<double>(corners.size());
    }
  }
  return middle;
}

//------------------------------------------------------------------------------
void DressPoints(vtkPolyData* surface)
{
  const auto height = Made<vtkDoubleArray>("Height");
  const auto place = Made<vtkFloatArray>("Place", 3);
  const auto color = Made<vtkUnsignedCharArray>("Color", 3);
  const auto label = Made<vtkIntArray>("Label");
  const auto name = Made<vtkStringArray>("Name");
  const auto bit = Made<vtkBitArray>("Bit");
  const auto ghost = Made<vtkUnsignedCharArray>("vtkGhostType");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    height->InsertNextValue(p[2]);
    place->InsertNextTuple(p);
    color->InsertNextTuple3(std::round(HalfOfColors * (1.0 + p[0])),
      std::round(HalfOfColors * (1.0 + p[1])), std::round(HalfOfColors * (1.0 + p[2])));
    label->InsertNextValue(p[2] > 0.0 ? 5 : 2);
    name->InsertNextValue(p[2] > 0.0 ? "north" : "south");
    bit->InsertNextValue(p[2] > 0.0 ? 1 : 0);
    ghost->InsertNextValue(0);
  }
  vtkPointData* data = surface->GetPointData();
  for (vtkAbstractArray* array :
    std::initializer_list<vtkAbstractArray*>{ height, place, color, label, name, bit, ghost })
  {
    data->AddArray(array);
  }
  data->SetActiveScalars("Height");
  data->SetGlobalIds(NumbersFrom("Number", 1000, surface->GetNumberOfPoints()));
  data->SetPedigreeIds(NumbersFrom("Pedigree", 500, surface->GetNumberOfPoints()));
}

//------------------------------------------------------------------------------
void DressCells(vtkPolyData* surface)
{
  const auto middle = Made<vtkDoubleArray>("Middle", 3);
  const auto side = Made<vtkIntArray>("Side");
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    const Sample::Point m = MiddleOf(surface, i);
    middle->InsertNextTuple(m.data());
    side->InsertNextValue(m[2] > 0.0 ? 5 : 2);
  }
  surface->GetCellData()->SetVectors(middle);
  surface->GetCellData()->AddArray(side);
  surface->GetCellData()->SetGlobalIds(NumbersFrom("CellNumber", 70, surface->GetNumberOfCells()));
}

//------------------------------------------------------------------------------
testing::AssertionResult HasSameArrays(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* from = a->GetAbstractArray(i);
    int number = -1;
    vtkAbstractArray* to = b->GetAbstractArray(from->GetName(), number);
    if (!to || to->GetDataType() != from->GetDataType() ||
      to->GetNumberOfValues() != from->GetNumberOfValues() ||
      to->GetNumberOfComponents() != from->GetNumberOfComponents() ||
      a->IsArrayAnAttribute(i) != b->IsArrayAnAttribute(number))
    {
      return testing::AssertionFailure() << from->GetName() << " has changed or is not there";
    }
    for (vtkIdType v = 0; v < from->GetNumberOfValues(); ++v)
    {
      if (from->GetVariantValue(v) != to->GetVariantValue(v))
      {
        return testing::AssertionFailure() << from->GetName() << "[" << v << "] has changed";
      }
    }
  }
  return testing::AssertionSuccess();
}

//------------------------------------------------------------------------------
Sample::Point Direction(const Sample::Point& p)
{
  const double length = std::hypot(p[0], p[1], p[2]);
  return { p[0] / length, p[1] / length, p[2] / length };
}

//------------------------------------------------------------------------------
/// Is the tuple scale * (shift + point) within the tolerance?
bool IsAbout(vtkDataArray* array, vtkIdType i, const Sample::Point& point, double tolerance,
  double shift = 0.0, double scale = 1.0)
{
  bool isAbout = array != nullptr;
  for (int c = 0; isAbout && c < 3; ++c)
  {
    const double expected = scale * (shift + point[static_cast<std::size_t>(c)]);
    isAbout = std::abs(array->GetComponent(i, c) - expected) <= scale * tolerance;
  }
  return isAbout;
}

} // namespace

namespace Sample
{

//------------------------------------------------------------------------------
Surface Dressed(vtkPolyData* surface)
{
  const auto dressed = Surface::New();
  dressed->DeepCopy(surface);
  DressPoints(dressed);
  DressCells(dressed);
  const auto patient = Made<vtkStringArray>("Patient");
  patient->InsertNextValue("Anna");
  dressed->GetFieldData()->AddArray(patient);
  return dressed;
}

} // namespace Sample

//------------------------------------------------------------------------------
testing::AssertionResult HasSameData(vtkPolyData* input, vtkPolyData* output)
{
  const auto points = HasSameArrays(input->GetPointData(), output->GetPointData());
  return points ? HasSameArrays(input->GetCellData(), output->GetCellData()) : points;
}

//------------------------------------------------------------------------------
testing::AssertionResult HasDataOfDirections(vtkPolyData* output, double tolerance, double edge)
{
  vtkPointData* data = output->GetPointData();
  auto* names = vtkStringArray::SafeDownCast(data->GetAbstractArray("Name"));
  if (!names || !data->GetArray("Height") || !data->GetArray("Label") || !data->GetArray("Bit"))
  {
    return testing::AssertionFailure() << "arrays are missing";
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    Sample::Point p;
    output->GetPoint(i, p.data());
    p = Direction(p);
    const double label = data->GetArray("Label")->GetTuple1(i);
    const bool isNorth = label == 5.0;
    const bool isOfOneKind = (isNorth || label == 2.0) &&
      names->GetValue(i) == (isNorth ? "north" : "south") &&
      data->GetArray("Bit")->GetTuple1(i) == (isNorth ? 1.0 : 0.0);
    const bool isRight = std::abs(p[2]) < edge || isNorth == (p[2] > 0.0);
    if (!isOfOneKind || !isRight ||
      std::abs(data->GetArray("Height")->GetTuple1(i) - p[2]) > tolerance ||
      !IsAbout(data->GetArray("Place"), i, p, tolerance) ||
      !IsAbout(data->GetArray("Color"), i, p, tolerance + 1.0 / HalfOfColors, 1.0, HalfOfColors))
    {
      return testing::AssertionFailure() << "point " << i << " has data of another place";
    }
  }
  return testing::AssertionSuccess();
}

//------------------------------------------------------------------------------
testing::AssertionResult HasCellDataOfDirections(vtkPolyData* output, double tolerance)
{
  vtkCellData* data = output->GetCellData();
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    const Sample::Point m = Direction(MiddleOf(output, i));
    const bool isNorth = data->GetArray("Side") && data->GetArray("Side")->GetTuple1(i) == 5.0;
    if (!IsAbout(data->GetArray("Middle"), i, m, tolerance) ||
      (std::abs(m[2]) > tolerance && isNorth != (m[2] > 0.0)))
    {
      return testing::AssertionFailure() << "cell " << i << " has data of another place";
    }
  }
  return testing::AssertionSuccess();
}
