// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "CellReading.h"
#include "Mesh/PolygonTriangulation.h"
#include "Mesh/UsablePart.h"

#include "vtkPolyData.h"

#include <sstream>
#include <string>

namespace KernelBridge
{

namespace
{

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
Surface SplitIntoTriangles(const Surface& surface, const evolving::Execution& execution)
{
  Surface split;
  std::vector<evolving::Index> oldFace;
  split.mesh = evolving::triangulate(surface.mesh, oldFace, execution);
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
Surface ReadTriangles(vtkPolyData* input, const evolving::Execution& execution)
{
  Surface surface = ReadSurface(input);
  return surface.mesh.hasOnlyTriangles() ? surface : SplitIntoTriangles(surface, execution);
}

//------------------------------------------------------------------------------
Surface ReadPointSet(vtkPolyData* input)
{
  Surface set = ReadAnyPointSet(input);
  RequireUndamaged(set);
  return set;
}

//------------------------------------------------------------------------------
UsableMesh ReadUsable(vtkPolyData* input, const evolving::Execution& execution)
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
    usable.mesh = evolving::triangulate(usable.mesh, oldFace, execution);
  }
  return usable;
}

//------------------------------------------------------------------------------
bool HasFaces(vtkPolyData* input)
{
  return input->GetNumberOfPolys() + input->GetNumberOfStrips() > 0;
}

} // namespace KernelBridge
