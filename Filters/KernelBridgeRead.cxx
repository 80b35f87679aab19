// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "CellReading.h"
#include "Mesh/UsablePart.h"

#include "vtkPolyData.h"

#include <numeric>
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
std::vector<vtkIdType> Numbers(evolving::Index count)
{
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

//------------------------------------------------------------------------------
Surface SplitIntoTriangles(const Surface& surface, const evolving::Execution& execution)
{
  Surface split;
  std::vector<evolving::Index> oldFace;
  split.mesh = evolving::triangulate(surface.mesh, oldFace, execution);
  split.cellOfFace = Chosen(surface.cellOfFace, oldFace);
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
  const bool hasFaces = HasFaces(input);
  const Surface surface = hasFaces ? ReadAnySurface(input) : ReadAnyPointSet(input);
  const evolving::DamagedParts damaged = evolving::findDamagedParts(surface.mesh);
  if (static_cast<std::size_t>(damaged.count()) == surface.cellOfFace.size())
  {
    throw evolving::InputError("None of the input's faces or points can be used: all have "
                               "coordinates that are not finite or fewer than three corners; check "
                               "what produces them.");
  }
  UsableMesh usable;
  usable.mesh = surface.mesh;
  usable.cellOfFace = surface.cellOfFace;
  usable.pointOfVertex = hasFaces ? Numbers(surface.mesh.vertexCount()) : surface.pointOfVertex;
  if (damaged.count() > 0)
  {
    std::vector<evolving::Index> oldNumber;
    usable.mesh = evolving::withoutDamagedParts(surface.mesh, &oldNumber);
    usable.cellOfFace = Chosen(surface.cellOfFace, oldNumber);
    usable.pointOfVertex =
      hasFaces ? usable.pointOfVertex : Chosen(surface.pointOfVertex, oldNumber);
    const vtkIdType first = surface.cellOfFace[static_cast<std::size_t>(damaged.first)];
    const bool isCell = hasFaces || input->GetNumberOfVerts() > 0;
    usable.leftOut = evolving::describeLeftOut(
      damaged, surface.mesh, (isCell ? "cell " : "point ") + std::to_string(first));
  }
  if (!usable.mesh.hasOnlyTriangles())
  {
    std::vector<evolving::Index> oldFace;
    usable.mesh = evolving::triangulate(usable.mesh, oldFace, execution);
    usable.cellOfFace = Chosen(usable.cellOfFace, oldFace);
  }
  return usable;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> Chosen(
  const std::vector<vtkIdType>& all, const std::vector<evolving::Index>& numbers)
{
  std::vector<vtkIdType> chosen;
  chosen.reserve(numbers.size());
  for (const evolving::Index number : numbers)
  {
    chosen.push_back(all[static_cast<std::size_t>(number)]);
  }
  return chosen;
}

//------------------------------------------------------------------------------
bool HasFaces(vtkPolyData* input)
{
  return input->GetNumberOfPolys() + input->GetNumberOfStrips() > 0;
}

} // namespace KernelBridge
