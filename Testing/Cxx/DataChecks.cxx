// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataChecks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

//------------------------------------------------------------------------------
testing::AssertionResult HasOnlyNumbers(vtkFieldData* arrays)
{
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = arrays->GetArray(a);
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        if (!std::isfinite(array->GetComponent(i, c)))
        {
          return testing::AssertionFailure()
            << array->GetName() << "[" << i << "][" << c << "] is " << array->GetComponent(i, c);
        }
      }
    }
  }
  return testing::AssertionSuccess();
}

//------------------------------------------------------------------------------
testing::AssertionResult HasFinitePoints(vtkDataSet* data)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return testing::AssertionFailure()
        << "point " << i << " is " << p[0] << " " << p[1] << " " << p[2];
    }
  }
  return testing::AssertionSuccess();
}

} // namespace

//------------------------------------------------------------------------------
testing::AssertionResult IsFinite(vtkDataObject* data)
{
  testing::AssertionResult result = HasOnlyNumbers(data->GetFieldData());
  if (auto* table = vtkTable::SafeDownCast(data))
  {
    return result ? HasOnlyNumbers(table->GetRowData()) : result;
  }
  auto* set = vtkDataSet::SafeDownCast(data);
  result = result ? HasFinitePoints(set) : result;
  result = result ? HasOnlyNumbers(set->GetPointData()) : result;
  return result ? HasOnlyNumbers(set->GetCellData()) : result;
}

//------------------------------------------------------------------------------
testing::AssertionResult IsInitialized(vtkDataObject* data)
{
  for (int type = 0; type < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++type)
  {
    vtkFieldData* arrays = data->GetAttributesAsFieldData(type);
    if (arrays && arrays->GetNumberOfArrays() > 0)
    {
      return testing::AssertionFailure() << "array " << arrays->GetArrayName(0) << " is there";
    }
    if (type != vtkDataObject::FIELD && data->GetNumberOfElements(type) > 0)
    {
      return testing::AssertionFailure()
        << data->GetNumberOfElements(type) << " elements of type " << type << " are there";
    }
  }
  return testing::AssertionSuccess();
}

//------------------------------------------------------------------------------
testing::AssertionResult IsOneSentence(const std::string& text)
{
  const bool isLine = text.find('\n') == std::string::npos;
  if (text.size() < 10 || !isLine || text.back() != '.' || text.find(". ") != std::string::npos)
  {
    return testing::AssertionFailure() << "\"" << text << "\" is not one sentence";
  }
  return testing::AssertionSuccess();
}

//------------------------------------------------------------------------------
testing::AssertionResult SameBits(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a->GetDataType() != b->GetDataType() ||
    a->GetNumberOfValues() != b->GetNumberOfValues() ||
    a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return testing::AssertionFailure() << "the arrays have different shapes";
  }
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      const double x = a->GetComponent(i, c);
      const double y = b->GetComponent(i, c);
      if (!(x == y) || std::signbit(x) != std::signbit(y))
      {
        return testing::AssertionFailure() << "[" << i << "]: " << x << " and " << y;
      }
    }
  }
  return testing::AssertionSuccess();
}

//------------------------------------------------------------------------------
testing::AssertionResult SameImage(vtkImageData* a, vtkImageData* b)
{
  const bool sameGrid = std::equal(a->GetExtent(), a->GetExtent() + 6, b->GetExtent()) &&
    std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin()) &&
    std::equal(a->GetSpacing(), a->GetSpacing() + 3, b->GetSpacing());
  if (!sameGrid)
  {
    return testing::AssertionFailure() << "the grids differ";
  }
  return SameBits(a->GetPointData()->GetScalars(), b->GetPointData()->GetScalars());
}

//------------------------------------------------------------------------------
testing::AssertionResult SamePointArrays(vtkPolyData* a, vtkPolyData* b, double tolerance)
{
  for (int k = 0; k < a->GetPointData()->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* x = a->GetPointData()->GetArray(k);
    vtkDataArray* y = b->GetPointData()->GetArray(x->GetName());
    if (!y || x->GetNumberOfValues() != y->GetNumberOfValues())
    {
      return testing::AssertionFailure() << x->GetName() << " has another shape";
    }
    const double scale = x->GetMaxNorm();
    for (vtkIdType i = 0; i < x->GetNumberOfValues(); ++i)
    {
      const int n = x->GetNumberOfComponents();
      const double p = x->GetComponent(i / n, static_cast<int>(i % n));
      const double q = y->GetComponent(i / n, static_cast<int>(i % n));
      if (!(std::abs(p - q) <= tolerance * scale))
      {
        return testing::AssertionFailure()
          << x->GetName() << "[" << i << "]: " << p << " and " << q << ", largest " << scale;
      }
    }
  }
  return testing::AssertionSuccess();
}

//------------------------------------------------------------------------------
double FieldValue(vtkDataObject* data, const char* name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfValues() == 1 ? array->GetTuple1(0)
                                                  : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
std::string FieldText(vtkDataObject* data, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
  return array && array->GetNumberOfValues() == 1 ? array->GetValue(0) : std::string();
}

//------------------------------------------------------------------------------
std::vector<std::string> Sorted(std::vector<std::string> names)
{
  std::sort(names.begin(), names.end());
  return names;
}

//------------------------------------------------------------------------------
std::vector<std::string> ArrayNames(vtkFieldData* arrays)
{
  std::vector<std::string> names;
  for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
  {
    names.emplace_back(arrays->GetAbstractArray(a)->GetName());
  }
  return Sorted(names);
}

//------------------------------------------------------------------------------
std::vector<std::string> ColumnNames(vtkTable* table)
{
  return ArrayNames(table->GetRowData());
}

//------------------------------------------------------------------------------
Range RangeOverPoints(vtkDataSet* data, const std::function<double(const double point[3])>& value)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  Range range{ Infinity, -Infinity };
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    range.Smallest = std::min(range.Smallest, value(p));
    range.Largest = std::max(range.Largest, value(p));
  }
  return range;
}

//------------------------------------------------------------------------------
Range DistanceFromOrigin(vtkDataSet* data)
{
  return RangeOverPoints(data, [](const double p[3]) { return std::hypot(p[0], p[1], p[2]); });
}
