// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "Mesh/PointWelding.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace KernelBridge
{

//------------------------------------------------------------------------------
WeldedSurface ReadWelded(vtkPolyData* input)
{
  const evolving::SurfaceMesh mesh = ReadSurface(input).mesh;
  WeldedSurface surface;
  const std::vector<evolving::Index> first = evolving::verticesToJoin(mesh);
  std::vector<evolving::Index> oldVertex;
  surface.mesh = evolving::joinVertices(mesh, first, &oldVertex);
  // Points that no face uses move with the vertex at their place.
  surface.vertexOfPoint = evolving::vertexOfEachPoint(mesh.points, surface.mesh.points);
  std::vector<evolving::Index> numbers(mesh.points.size(), evolving::NoIndex);
  for (std::size_t vertex = 0; vertex < oldVertex.size(); ++vertex)
  {
    numbers[evolving::at(oldVertex[vertex])] = static_cast<evolving::Index>(vertex);
  }
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    const bool isUsed =
      first[i] != evolving::NoIndex && numbers[evolving::at(first[i])] != evolving::NoIndex;
    surface.vertexOfPoint[i] = isUsed ? numbers[evolving::at(first[i])] : surface.vertexOfPoint[i];
  }
  return surface;
}

//------------------------------------------------------------------------------
void MoveWeldedPoints(const WeldedSurface& surface, const std::vector<evolving::Vec3>& points,
  int pointType, vtkPolyData* output)
{
  vtkPoints* old = output->GetPoints();
  vtkNew<vtkPoints> moved;
  moved->SetDataType(pointType);
  moved->SetNumberOfPoints(old->GetNumberOfPoints());
  moved->GetData()->DeepCopy(old->GetData());
  for (std::size_t i = 0; i < surface.vertexOfPoint.size(); ++i)
  {
    const evolving::Index vertex = surface.vertexOfPoint[i];
    if (vertex != evolving::NoIndex)
    {
      moved->SetPoint(static_cast<vtkIdType>(i), points[static_cast<std::size_t>(vertex)].data());
    }
  }
  output->SetPoints(moved);
}

//------------------------------------------------------------------------------
evolving::StateArrays Unweld(const WeldedSurface& surface, const evolving::StateArrays& arrays)
{
  const auto spread = [&surface](const auto& values, const auto& zero)
  {
    using Values = std::decay_t<decltype(values)>;
    Values spreadValues;
    for (const evolving::Index vertex : surface.vertexOfPoint)
    {
      const bool has = vertex != evolving::NoIndex && !values.empty();
      spreadValues.push_back(has ? values[static_cast<std::size_t>(vertex)] : zero);
    }
    return spreadValues;
  };
  const evolving::Vec3 zero = evolving::Vec3::Zero();
  evolving::StateArrays points;
  points.normal = spread(arrays.normal, zero);
  points.meanCurvature = spread(arrays.meanCurvature, 0.0);
  points.coVolume = spread(arrays.coVolume, 0.0);
  points.tangentialVelocity = spread(arrays.tangentialVelocity, zero);
  points.redistributionPotential = spread(arrays.redistributionPotential, 0.0);
  return points;
}

} // namespace KernelBridge
