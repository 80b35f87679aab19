// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "EvolutionJudge.h"

#include "OutputChecks.h"
#include "Verdict.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace robustness
{

namespace
{

/// Degrees: both sides round angles and lengths, nothing more.
constexpr double AngleRounding = 1e-5;
constexpr double RelativeRounding = 1e-6;

bool hasOnlyTriangles(const Surface& surface)
{
  return std::all_of(
    surface.faces.begin(), surface.faces.end(), [](const Cell& face) { return face.size() == 3; });
}

void judgeDistanceRecord(vtkPolyData* state)
{
  vtkDataArray* distances = state->GetPointData()->GetArray("SignedDistance");
  double largest = 0.0;
  for (vtkIdType i = 0; distances && i < distances->GetNumberOfTuples(); ++i)
  {
    largest = std::max(largest, std::abs(distances->GetTuple1(i)));
  }
  requireStated(
    "MaxDistance", fieldNumber(state, "MaxDistance"), largest, RelativeRounding * largest);
}

void requireShapeArrays(vtkPolyData* state)
{
  vtkDataArray* normals = pointArray(state, "Normals", 3);
  pointArray(state, "MeanCurvature", 1);
  pointArray(state, "CoVolume", 1);
  pointArray(state, "TangentialVelocity", 3);
  pointArray(state, "RedistributionPotential", 1);
  pointArray(state, "NormalVelocity", 1);
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    Vec3 normal;
    normals->GetTuple(i, normal.data());
    require(
      normal.norm() < 1.0 + 1e-6, Fault::Misstated, "a normal has the length ", normal.norm());
  }
}

} // namespace

void judgeMeasures(const Surface& surface, const Topology& topology, vtkPolyData* state)
{
  requireStated(
    "MinAngle", fieldNumber(state, "MinAngle"), smallestAngleOf(surface), AngleRounding);
  const double area = areaOf(surface);
  if (hasOnlyTriangles(surface))
  {
    requireStated("Area", fieldNumber(state, "Area"), area, RelativeRounding * area);
  }
  if (topology.isClosed() && topology.isOriented())
  {
    const double volume = volumeOf(surface, middleOf(surface));
    requireStated("Volume", fieldNumber(state, "Volume"), volume,
      RelativeRounding * std::max(std::abs(volume), std::pow(area, 1.5)));
  }
}

void judgeState(const Subject& start, bool hasNewElements, vtkPolyData* state)
{
  const Surface surface = surfaceOf(state);
  requireUsableFaces(surface);
  require(!surface.faces.empty(), Fault::Nothing, "the state has no faces");
  const Topology topology = topologyOf(surface);
  require(topology.isManifold(), Fault::NotManifold, topology.crowdedEdges,
    " edges of several faces, ", topology.crowdedVertices, " vertices of several fans");
  require(topology.isOriented(), Fault::NotOriented, topology.turnedEdges,
    " edges between faces that face opposite ways");
  require(!start.topology.isClosed() || topology.isClosed(), Fault::Borders, topology.borderEdges,
    " border edges, the start is closed");
  if (!hasNewElements)
  {
    require(topology.faces == start.topology.faces && topology.vertices == start.topology.vertices,
      Fault::ChangedInput, "the start has ", start.topology.faces, " faces and ",
      start.topology.vertices, " points, the state ", topology.faces, " and ", topology.vertices);
  }
  requireShapeArrays(state);
  judgeMeasures(surface, topology, state);
  judgeDistanceRecord(state);
}

void judgeHistory(vtkTable* history, vtkPolyData* last, const std::vector<std::string>& columns)
{
  requireFinite(history);
  const vtkIdType rows = history->GetNumberOfRows();
  const double iteration = fieldNumber(last, "Iteration");
  require(rows >= 1 && static_cast<double>(rows) >= iteration + 1.0, Fault::Misstated,
    "History has ", rows, " rows at iteration ", iteration);
  for (const std::string& name : columns)
  {
    vtkDataArray* column = history->GetRowData()->GetArray(name.c_str());
    require(column != nullptr, Fault::Misstated, "History has no column ", name);
    const double value = column->GetTuple1(static_cast<vtkIdType>(iteration));
    const double stated = fieldNumber(last, name.c_str());
    require(
      value == stated, Fault::Misstated, "History says ", name, " ", value, ", the state ", stated);
  }
}

} // namespace robustness
