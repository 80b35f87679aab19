// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EvolutionStart.h"

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
  const evolving::SurfaceMesh start =
    evolving::weldCoincidentPoints(surface.mesh, &oldVertex, &oldFace);
  this->Start = std::make_shared<const evolving::SurfaceMesh>(
    IsInsideOut(start) ? evolving::reversed(start) : start);
  this->Elements.points.assign(oldVertex.begin(), oldVertex.end());
  this->Elements.cells = KernelBridge::Chosen(surface.cellOfFace, oldFace);
}

//------------------------------------------------------------------------------
void EvolutionStart::WriteData(vtkPolyData* input, const evolving::FlowState& state,
  vtkPolyData* output, const evolving::Execution& execution)
{
  if (state.startPoints)
  {
    this->FindPlaces(state, execution);
    DataTransfer::InterpolatePoints(input, this->PointPlaces, output);
    DataTransfer::CopyCells(input, this->CellPlaces, output);
  }
  else if (evolving::haveEqualFaces(*state.origin, *this->Start))
  {
    DataTransfer::Copy(input, this->Elements, output);
  }
}

//------------------------------------------------------------------------------
void EvolutionStart::FindPlaces(
  const evolving::FlowState& state, const evolving::Execution& execution)
{
  if (!this->Closest)
  {
    std::vector<evolving::Index> oldFace;
    const evolving::SurfaceMesh triangles = evolving::triangulate(*this->Start, oldFace, execution);
    this->Closest = std::make_unique<const ClosestElements>(triangles, this->Elements.points,
      KernelBridge::Chosen(this->Elements.cells, oldFace), execution);
  }
  if (this->Written != state.startPoints)
  {
    this->PointPlaces = this->Closest->MixturesAt(*state.startPoints, execution);
    this->CellPlaces =
      this->Closest->CellsAt(FaceCenters(*state.origin, *state.startPoints), execution);
    this->Written = state.startPoints;
  }
}
