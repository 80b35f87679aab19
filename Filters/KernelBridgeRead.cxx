// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "Mesh/PolygonTriangulation.h"
#include "Mesh/UsablePart.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>

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

//------------------------------------------------------------------------------
/// With all corner numbers in range, and whatever else may be wrong.
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

//------------------------------------------------------------------------------
/// Of a face, or the point of that number where there are no faces.
evolving::Vec3 FirstNotFinite(const evolving::SurfaceMesh& mesh, evolving::Index number)
{
  const bool isFace = mesh.faceCount() > 0;
  evolving::Index corner = 0;
  while (isFace && mesh.facePoint(number, corner).allFinite())
  {
    ++corner;
  }
  return isFace ? mesh.facePoint(number, corner) : mesh.points[static_cast<std::size_t>(number)];
}

//------------------------------------------------------------------------------
/// What the kernel's validate() requires, in the input's cell numbers, which it does not know.
void RequireUndamaged(const Surface& surface)
{
  const evolving::Index first = evolving::findDamagedParts(surface.mesh).first;
  if (first == evolving::NoIndex)
  {
    return;
  }
  const bool isFace = surface.mesh.faceCount() > 0;
  std::ostringstream message;
  message << (isFace ? "Cell " : "The vertex cell or point ")
          << surface.cellOfFace[static_cast<std::size_t>(first)];
  if (isFace && surface.mesh.faceSize(first) < 3)
  {
    message << " is a face of " << surface.mesh.faceSize(first) << " corners, expected at least 3";
  }
  else
  {
    message << " has the coordinates (" << FirstNotFinite(surface.mesh, first).transpose()
            << "), expected finite numbers";
  }
  message << "; remove or repair it before this filter.";
  throw evolving::InputError(message.str());
}

//------------------------------------------------------------------------------
Surface SplitIntoTriangles(const Surface& surface)
{
  Surface split;
  std::vector<evolving::Index> oldFace;
  split.mesh = evolving::triangulate(surface.mesh, oldFace);
  for (const evolving::Index face : oldFace)
  {
    split.cellOfFace.push_back(surface.cellOfFace[static_cast<std::size_t>(face)]);
  }
  return split;
}

} // namespace

//------------------------------------------------------------------------------
Surface ReadSurface(vtkPolyData* input)
{
  Surface surface = ReadAnySurface(input);
  RequireUndamaged(surface);
  return surface;
}

//------------------------------------------------------------------------------
Surface ReadTriangles(vtkPolyData* input)
{
  Surface surface = ReadSurface(input);
  return surface.mesh.hasOnlyTriangles() ? surface : SplitIntoTriangles(surface);
}

//------------------------------------------------------------------------------
Surface ReadPointSet(vtkPolyData* input)
{
  Surface set = ReadAnyPointSet(input);
  RequireUndamaged(set);
  return set;
}

//------------------------------------------------------------------------------
UsableMesh ReadUsable(vtkPolyData* input)
{
  const Surface surface = HasFaces(input) ? ReadAnySurface(input) : ReadAnyPointSet(input);
  const evolving::DamagedParts damaged = evolving::findDamagedParts(surface.mesh);
  if (static_cast<std::size_t>(damaged.count()) == surface.cellOfFace.size())
  {
    throw evolving::InputError("None of the input's faces or points can be used: all have "
                               "coordinates that are not finite or fewer than three corners; check "
                               "what produces them.");
  }
  UsableMesh usable;
  usable.mesh = surface.mesh;
  if (damaged.count() > 0)
  {
    usable.mesh = evolving::withoutDamagedParts(surface.mesh);
    const vtkIdType first = surface.cellOfFace[static_cast<std::size_t>(damaged.first)];
    const bool isCell = HasFaces(input) || input->GetNumberOfVerts() > 0;
    usable.leftOut = evolving::describeLeftOut(
      damaged, surface.mesh, (isCell ? "cell " : "point ") + std::to_string(first));
  }
  if (!usable.mesh.hasOnlyTriangles())
  {
    std::vector<evolving::Index> oldFace;
    usable.mesh = evolving::triangulate(usable.mesh, oldFace);
  }
  return usable;
}

//------------------------------------------------------------------------------
bool HasFaces(vtkPolyData* input)
{
  return input->GetNumberOfPolys() + input->GetNumberOfStrips() > 0;
}

} // namespace KernelBridge
