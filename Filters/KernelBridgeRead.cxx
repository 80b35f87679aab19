// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <utility>

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
    std::vector<evolving::Index> corners;
    std::transform(ids, ids + size, std::back_inserter(corners),
      [input](vtkIdType id) { return CheckedIndex(id, input); });
    surface.mesh.addFace(corners);
    surface.cellOfFace.push_back(cell);
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
/// The corners (numbers inside the face) of the triangles of one polygon.
void TriangulateFace(const evolving::SurfaceMesh& mesh, evolving::Index face, vtkIdList* corners)
{
  const evolving::Index size = mesh.faceSize(face);
  vtkNew<vtkPolygon> polygon;
  polygon->Points->SetDataTypeToDouble();
  polygon->Points->SetNumberOfPoints(size);
  polygon->PointIds->SetNumberOfIds(size);
  for (evolving::Index k = 0; k < size; ++k)
  {
    polygon->Points->SetPoint(k, mesh.facePoint(face, k).data());
    polygon->PointIds->SetId(k, k);
  }
  if (polygon->Triangulate(corners) && corners->GetNumberOfIds() == 3 * (size - 2))
  {
    return;
  }
  // A polygon without area has no ears; a fan covers the same points.
  corners->Reset();
  for (evolving::Index k = 1; k + 1 < size; ++k)
  {
    corners->InsertNextId(0);
    corners->InsertNextId(k);
    corners->InsertNextId(k + 1);
  }
}

//------------------------------------------------------------------------------
Surface SplitIntoTriangles(const Surface& surface)
{
  Surface split;
  split.mesh.points = surface.mesh.points;
  vtkNew<vtkIdList> corners;
  for (evolving::Index face = 0; face < surface.mesh.faceCount(); ++face)
  {
    TriangulateFace(surface.mesh, face, corners);
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); i += 3)
    {
      const auto vertex = [&](vtkIdType k) {
        return surface.mesh.faceVertex(face, static_cast<evolving::Index>(corners->GetId(i + k)));
      };
      split.mesh.addFace({ vertex(0), vertex(1), vertex(2) });
      split.cellOfFace.push_back(surface.cellOfFace[static_cast<std::size_t>(face)]);
    }
  }
  return split;
}

} // namespace

//------------------------------------------------------------------------------
Surface ReadSurface(vtkPolyData* input)
{
  Surface surface;
  surface.mesh.points = ReadPoints(input);
  ReadPolygons(input, surface);
  ReadStrips(input, surface);
  evolving::validate(surface.mesh);
  return surface;
}

//------------------------------------------------------------------------------
Surface ReadTriangles(vtkPolyData* input)
{
  Surface surface = ReadSurface(input);
  return surface.mesh.hasOnlyTriangles() ? surface : SplitIntoTriangles(surface);
}

//------------------------------------------------------------------------------
WeldedSurface ReadWelded(vtkPolyData* input)
{
  const evolving::SurfaceMesh mesh = ReadSurface(input).mesh;
  WeldedSurface surface;
  surface.mesh = evolving::weldCoincidentPoints(mesh);
  // Every point goes with the vertex that has its coordinates.
  const auto less = [](const evolving::Vec3& p, const evolving::Vec3& q)
  { return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end()); };
  std::map<evolving::Vec3, evolving::Index, decltype(less)> vertexAt(less);
  for (evolving::Index v = 0; v < surface.mesh.vertexCount(); ++v)
  {
    vertexAt.emplace(surface.mesh.points[static_cast<std::size_t>(v)], v);
  }
  for (const evolving::Vec3& point : mesh.points)
  {
    const auto vertex = point.allFinite() ? vertexAt.find(point) : vertexAt.end();
    surface.vertexOfPoint.push_back(vertex == vertexAt.end() ? evolving::NoIndex : vertex->second);
  }
  return surface;
}

//------------------------------------------------------------------------------
Surface ReadPointSet(vtkPolyData* input)
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
  evolving::validate(set.mesh);
  return set;
}

//------------------------------------------------------------------------------
bool HasFaces(vtkPolyData* input)
{
  return input->GetNumberOfPolys() + input->GetNumberOfStrips() > 0;
}

//------------------------------------------------------------------------------
evolving::ScalarImage ReadImage(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars)
  {
    throw evolving::InputError(
      "The image on the second input has no active point scalars, "
      "expected a distance or an intensity; choose one of its point arrays, or use Cell Data "
      "to Point Data first.");
  }
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    throw evolving::InputError("The image on the second input is rotated (its direction matrix is "
                               "not the identity), expected one along the axes; resample it.");
  }
  evolving::DistanceGrid grid;
  image->GetOrigin(grid.origin.data());
  image->GetSpacing(grid.spacing.data());
  image->GetExtent(grid.extent.data());
  std::vector<float> values(static_cast<std::size_t>(scalars->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<float>(scalars->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return evolving::ScalarImage(grid, std::move(values));
}

//------------------------------------------------------------------------------
int PointType(vtkPointSet* input)
{
  const bool isDouble =
    input && input->GetPoints() && input->GetPoints()->GetDataType() == VTK_DOUBLE;
  return isDouble ? VTK_DOUBLE : VTK_FLOAT;
}

} // namespace KernelBridge
