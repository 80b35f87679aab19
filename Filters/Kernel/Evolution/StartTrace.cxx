// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StartTrace.h"

#include "Mesh/PolygonTriangulation.h"
#include "Trees/TrianglePlaces.h"

namespace evolving
{

namespace
{

SurfaceMesh trianglesOfFaces(const SurfaceMesh& mesh, const Execution& execution)
{
  std::vector<Index> oldFace;
  return mesh.hasOnlyTriangles() ? mesh : triangulate(mesh, oldFace, execution);
}

} // namespace

StartTrace::StartTrace(const SurfaceMesh& start, const Execution& execution)
  : Start(trianglesOfFaces(start, execution), execution)
{
}

std::vector<Vec3> StartTrace::carryOver(const SurfaceMesh& before,
  const std::vector<Vec3>& comesFrom, const SurfaceMesh& after, const Execution& execution) const
{
  const SurfaceMesh triangles = trianglesOfFaces(before, execution);
  const AABBTree tree(triangles, execution);
  const auto places = closestPlaces(tree, after.points, execution);
  std::vector<Vec3> points(places.size(), Vec3::Zero());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Index vertex = triangles.faceVertex(places[i].triangle, k);
      points[i] += places[i].weights[k] * comesFrom[static_cast<std::size_t>(vertex)];
    }
    // Between three points of a surface that is curved lies one that is not on it.
    points[i] = this->Start.closest(points[i]).at.point;
  }
  return points;
}

} // namespace evolving
