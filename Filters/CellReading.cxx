// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellReading.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <sstream>
#include <vector>

namespace KernelBridge
{

namespace
{

//------------------------------------------------------------------------------
std::vector<evolving::Vec3> ReadPoints(vtkPointSet* input)
{
  const vtkIdType count = input->GetNumberOfPoints();
  if (count > std::numeric_limits<evolving::Index>::max())
  {
    std::ostringstream message;
    message << "The input has " << count << " points, at most "
            << std::numeric_limits<evolving::Index>::max()
            << " are supported; decimate it before this filter.";
    throw evolving::InputError(message.str());
  }
  std::vector<evolving::Vec3> points(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    input->GetPoint(i, points[static_cast<std::size_t>(i)].data());
  }
  return points;
}

//------------------------------------------------------------------------------
/// A point number as the kernel's type, checked before it is narrowed.
evolving::Index CheckedIndex(vtkIdType id, vtkPolyData* input)
{
  if (id < 0 || id >= input->GetNumberOfPoints())
  {
    std::ostringstream message;
    message << "A cell refers to point " << id << ", but there are only "
            << input->GetNumberOfPoints() << " points; the file is damaged, export it again.";
    throw evolving::InputError(message.str());
  }
  return static_cast<evolving::Index>(id);
}

//------------------------------------------------------------------------------
void AddFace(
  const vtkIdType* ids, vtkIdType size, vtkIdType cell, vtkPolyData* input, Surface& surface)
{
  std::vector<evolving::Index> corners;
  std::transform(ids, ids + size, std::back_inserter(corners),
    [input](vtkIdType id) { return CheckedIndex(id, input); });
  surface.mesh.addFace(corners);
  surface.cellOfFace.push_back(cell);
}

//------------------------------------------------------------------------------
/// The cell ids of a polydata run over its vertices, lines, polygons and strips in this order.
void ReadPolygons(vtkPolyData* input, Surface& surface)
{
  vtkIdType cell = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const auto cells = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    AddFace(ids, size, cell, input, surface);
  }
}

//------------------------------------------------------------------------------
void ReadStrips(vtkPolyData* input, Surface& surface)
{
  vtkIdType cell =
    input->GetNumberOfVerts() + input->GetNumberOfLines() + input->GetNumberOfPolys();
  const auto strips = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    strips->GetCurrentCell(size, ids);
    if (size < 3)
    {
      // Damaged as a polygon of so few corners is.
      AddFace(ids, size, cell, input, surface);
    }
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      // Every second triangle of a strip runs the other way.
      const vtkIdType odd = i % 2;
      surface.mesh.addFace({ CheckedIndex(ids[i], input), CheckedIndex(ids[i + 1 + odd], input),
        CheckedIndex(ids[i + 2 - odd], input) });
      surface.cellOfFace.push_back(cell);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
Surface ReadAnySurface(vtkPolyData* input)
{
  Surface surface;
  surface.mesh.points = ReadPoints(input);
  ReadPolygons(input, surface);
  ReadStrips(input, surface);
  return surface;
}

//------------------------------------------------------------------------------
Surface ReadAnyPointSet(vtkPolyData* input)
{
  const std::vector<evolving::Vec3> all = ReadPoints(input);
  Surface set;
  const auto add = [&](evolving::Index point, vtkIdType cell)
  {
    set.mesh.points.push_back(all[static_cast<std::size_t>(point)]);
    set.cellOfFace.push_back(cell);
    set.pointOfVertex.push_back(point);
  };
  const auto cells = vtk::TakeSmartPointer(input->GetVerts()->NewIterator());
  vtkIdType cell = 0;
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    std::for_each(ids, ids + size, [&](vtkIdType id) { add(CheckedIndex(id, input), cell); });
  }
  if (input->GetNumberOfVerts() == 0)
  {
    for (evolving::Index point = 0; point < static_cast<evolving::Index>(all.size()); ++point)
    {
      add(point, point);
    }
  }
  return set;
}

} // namespace KernelBridge
