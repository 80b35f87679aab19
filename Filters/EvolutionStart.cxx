// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EvolutionStart.h"

#include <optional>
#include <utility>

namespace
{

//------------------------------------------------------------------------------
bool IsInsideOut(const evolving::SurfaceMesh& start)
{
  return evolving::summarizeTopology(start).isClosed() && evolving::signedVolume(start) < 0.0;
}

} // namespace

//------------------------------------------------------------------------------
EvolutionStart::EvolutionStart(
  vtkPolyData* input, bool isSplit, const evolving::Execution& execution)
{
  const KernelBridge::Surface surface =
    isSplit ? KernelBridge::ReadTriangles(input, execution) : KernelBridge::ReadSurface(input);
  std::vector<evolving::Index> oldVertex;
  std::vector<evolving::Index> oldFace;
  const evolving::SurfaceMesh start = evolving::weldOpenParts(surface.mesh, &oldVertex, &oldFace);
  this->Start = std::make_shared<const evolving::SurfaceMesh>(
    IsInsideOut(start) ? evolving::reversed(start) : start);
  this->WithSlivers = this->Start;
  this->Elements.points.assign(oldVertex.begin(), oldVertex.end());
  this->Elements.cells = KernelBridge::Chosen(surface.cellOfFace, oldFace);
}

//------------------------------------------------------------------------------
bool EvolutionStart::TakeSliversOut()
{
  auto clean = this->Start->hasOnlyTriangles() ? evolving::withoutSlivers(*this->Start)
                                               : std::optional<evolving::SurfaceMesh>();
  if (clean)
  {
    this->Start = std::make_shared<const evolving::SurfaceMesh>(*std::move(clean));
  }
  return this->Start != this->WithSlivers;
}

//------------------------------------------------------------------------------
void EvolutionStart::WriteData(vtkPolyData* input, const evolving::FlowState& state,
  vtkPolyData* output, const evolving::Execution& execution)
{
  const bool hasStartElements =
    !state.startPoints && evolving::haveEqualFaces(*state.origin, *this->Start);
  if (hasStartElements && this->Start == this->WithSlivers)
  {
    DataTransfer::Copy(input, this->Elements, output);
  }
  else if (hasStartElements || state.startPoints)
  {
    this->FindPlaces(
      hasStartElements ? Points(this->Start, &this->Start->points) : Points(state.startPoints),
      *state.origin, execution);
    DataTransfer::InterpolatePoints(input, this->PointPlaces, output);
    DataTransfer::CopyCells(input, this->CellPlaces, output);
  }
}

//------------------------------------------------------------------------------
void EvolutionStart::FindPlaces(
  const Points& places, const evolving::SurfaceMesh& faces, const evolving::Execution& execution)
{
  if (!this->Closest)
  {
    std::vector<evolving::Index> oldFace;
    const evolving::SurfaceMesh triangles =
      evolving::triangulate(*this->WithSlivers, oldFace, execution);
    this->Closest = std::make_unique<const ClosestElements>(triangles, this->Elements.points,
      KernelBridge::Chosen(this->Elements.cells, oldFace), execution);
  }
  if (this->Written != places)
  {
    this->PointPlaces = this->Closest->MixturesAt(*places, execution);
    this->CellPlaces = this->Closest->CellsAt(FaceCenters(faces, *places), execution);
    this->Written = places;
  }
}
