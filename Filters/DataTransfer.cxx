// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DataTransfer.h"

#include "CarriedArrays.h"
#include "ResultArrays.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>

namespace DataTransfer
{

namespace
{

//------------------------------------------------------------------------------
/// PassData() would take roles away that `from` does not have.
void AddAll(vtkDataSetAttributes* from, vtkDataSetAttributes* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    const int role = from->IsArrayAnAttribute(i);
    const int number = to->AddArray(from->GetAbstractArray(i));
    if (role != -1)
    {
      to->SetActiveAttribute(number, role);
    }
  }
}

//------------------------------------------------------------------------------
void CopyTuples(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& ids, vtkDataSetAttributes* to)
{
  const auto count = static_cast<vtkIdType>(ids.size());
  vtkNew<vtkIdList> sources;
  sources->SetNumberOfIds(count);
  std::copy(ids.begin(), ids.end(), sources->GetPointer(0));
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(count);
  std::iota(places->GetPointer(0), places->GetPointer(0) + count, vtkIdType{ 0 });
  const auto copied = vtk::TakeSmartPointer(from->NewInstance());
  copied->CopyAllOn();
  copied->CopyAllocate(from, count);
  copied->CopyData(from, sources, places);
  AddAll(copied, to);
}

//------------------------------------------------------------------------------
void CopyNearest(
  vtkDataSetAttributes* from, const std::vector<Mixture>& points, vtkDataSetAttributes* to)
{
  std::vector<vtkIdType> nearest(points.size());
  std::transform(points.begin(), points.end(), nearest.begin(),
    [](const Mixture& mixture)
    {
      const auto largest = std::max_element(mixture.weights.begin(), mixture.weights.end());
      return mixture.points[static_cast<std::size_t>(largest - mixture.weights.begin())];
    });
  CopyTuples(from, nearest, to);
}

//------------------------------------------------------------------------------
void InterpolateTuples(
  vtkDataSetAttributes* from, const std::vector<Mixture>& points, vtkDataSetAttributes* to)
{
  const auto interpolated = vtk::TakeSmartPointer(from->NewInstance());
  interpolated->InterpolateAllocate(from, static_cast<vtkIdType>(points.size()));
  vtkNew<vtkIdList> corners;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    // A corner without weight does not count, even where its value is no number.
    corners->Reset();
    double weights[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (points[i].weights[k] > 0.0)
      {
        weights[corners->InsertNextId(points[i].points[k])] = points[i].weights[k];
      }
    }
    interpolated->InterpolatePoint(from, static_cast<vtkIdType>(i), corners, weights);
  }
  AddAll(interpolated, to);
}

//------------------------------------------------------------------------------
bool AreAll(const std::vector<vtkIdType>& ids, vtkIdType count)
{
  vtkIdType next = 0;
  return static_cast<vtkIdType>(ids.size()) == count &&
    std::all_of(ids.begin(), ids.end(), [&next](vtkIdType id) { return id == next++; });
}

//------------------------------------------------------------------------------
void CopyOrPass(vtkDataSetAttributes* from, const std::vector<vtkIdType>& ids, vtkIdType count,
  vtkDataSetAttributes* to)
{
  if (AreAll(ids, count))
  {
    AddAll(from, to);
    return;
  }
  CopyTuples(from, ids, to);
}

} // namespace

//------------------------------------------------------------------------------
void Copy(vtkPolyData* input, const Copies& copies, vtkPolyData* output)
{
  CopyOrPass(CarriedArrays::OfPoints(input), copies.points, input->GetNumberOfPoints(),
    output->GetPointData());
  const bool areParts =
    std::adjacent_find(copies.cells.begin(), copies.cells.end()) != copies.cells.end();
  const auto cells = CarriedArrays::OfCells(input);
  CopyOrPass(areParts ? CarriedArrays::WithoutIdentity(cells) : cells, copies.cells,
    input->GetNumberOfCells(), output->GetCellData());
}

//------------------------------------------------------------------------------
void InterpolatePoints(vtkPolyData* input, const std::vector<Mixture>& points, vtkPolyData* output)
{
  const auto data = CarriedArrays::WithoutIdentity(CarriedArrays::OfPoints(input));
  InterpolateTuples(CarriedArrays::Continuous(data), points, output->GetPointData());
  CopyNearest(CarriedArrays::Discrete(data), points, output->GetPointData());
}

//------------------------------------------------------------------------------
void CopyCells(vtkPolyData* input, const std::vector<vtkIdType>& cells, vtkPolyData* output)
{
  CopyTuples(
    CarriedArrays::WithoutIdentity(CarriedArrays::OfCells(input)), cells, output->GetCellData());
}

//------------------------------------------------------------------------------
void PassFieldData(vtkDataObject* input, vtkDataObject* output)
{
  vtkNew<vtkFieldData> passed;
  passed->PassData(input->GetFieldData());
  ResultArrays::Remove(passed);
  output->GetFieldData()->PassData(passed);
}

//------------------------------------------------------------------------------
void CopyWithoutTuples(vtkPolyData* input, vtkPolyData* output)
{
  if (!input)
  {
    return;
  }
  // Global ids too, which VTK copies only where it is told that they stay true.
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(CarriedArrays::OfPoints(input));
  output->GetCellData()->CopyAllOn();
  output->GetCellData()->CopyAllocate(CarriedArrays::OfCells(input));
}

} // namespace DataTransfer
