// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ClosestElements.h"

#include <algorithm>
#include <utility>

namespace
{

//------------------------------------------------------------------------------
/// The tree knows a point as a triangle of three equal corners.
evolving::SurfaceMesh AsTriangles(const evolving::SurfaceMesh& mesh)
{
  evolving::SurfaceMesh triangles = mesh;
  for (evolving::Index v = 0; mesh.faceCount() == 0 && v < mesh.vertexCount(); ++v)
  {
    triangles.addFace({ v, v, v });
  }
  return triangles;
}

} // namespace

//------------------------------------------------------------------------------
ClosestElements::ClosestElements(const evolving::SurfaceMesh& mesh,
  std::vector<vtkIdType> pointOfVertex, std::vector<vtkIdType> cellOfFace,
  const evolving::Execution& execution)
  : Mesh(AsTriangles(mesh))
  , PointOfVertex(std::move(pointOfVertex))
  , CellOfFace(std::move(cellOfFace))
  , Tree(this->Mesh, execution)
{
}

//------------------------------------------------------------------------------
std::vector<DataTransfer::Mixture> ClosestElements::MixturesAt(
  const std::vector<evolving::Vec3>& points, const evolving::Execution& execution) const
{
  const auto places = evolving::closestPlaces(this->Tree, points, execution);
  std::vector<DataTransfer::Mixture> mixtures(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto corner = static_cast<evolving::Index>(k);
      const evolving::Index vertex = this->Mesh.faceVertex(places[i].triangle, corner);
      mixtures[i].points[k] = this->PointOfVertex[static_cast<std::size_t>(vertex)];
      mixtures[i].weights[k] = places[i].weights[corner];
    }
  }
  return mixtures;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> ClosestElements::CellsAt(
  const std::vector<evolving::Vec3>& points, const evolving::Execution& execution) const
{
  const auto places = evolving::closestPlaces(this->Tree, points, execution);
  std::vector<vtkIdType> cells(places.size());
  std::transform(places.begin(), places.end(), cells.begin(),
    [this](const evolving::TrianglePlace& place)
    { return this->CellOfFace[static_cast<std::size_t>(place.triangle)]; });
  return cells;
}

//------------------------------------------------------------------------------
std::vector<evolving::Vec3> FaceCenters(
  const evolving::SurfaceMesh& mesh, const std::vector<evolving::Vec3>& points)
{
  std::vector<evolving::Vec3> centers(
    static_cast<std::size_t>(mesh.faceCount()), evolving::Vec3::Zero());
  for (evolving::Index face = 0; face < mesh.faceCount(); ++face)
  {
    evolving::Vec3& center = centers[static_cast<std::size_t>(face)];
    for (evolving::Index k = 0; k < mesh.faceSize(face); ++k)
    {
      center += points[static_cast<std::size_t>(mesh.faceVertex(face, k))];
    }
    center /= mesh.faceSize(face);
  }
  return centers;
}
