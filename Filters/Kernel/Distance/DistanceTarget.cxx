// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/DistanceTarget.h"

#include "Distance/FloatRange.h"
#include "Errors.h"
#include "Mesh/PointWelding.h"
#include "Mesh/PolygonTriangulation.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <sstream>
#include <utility>

namespace evolving
{

namespace
{

/// The numbers of the corner triples that no smaller number has, ascending.
std::vector<Index> firstOfEqual(const std::vector<std::array<Index, 3>>& corners)
{
  std::vector<Index> order(corners.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&corners](Index a, Index b) { return corners[at(a)] < corners[at(b)]; });
  order.erase(std::unique(order.begin(), order.end(),
                [&corners](Index a, Index b) { return corners[at(a)] == corners[at(b)]; }),
    order.end());
  std::sort(order.begin(), order.end());
  return order;
}

DistanceTarget targetOfPoints(const SurfaceMesh& mesh)
{
  DistanceTarget target;
  target.isPointSet = true;
  std::vector<Index> all(mesh.points.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<Index> first = firstOfEqualPoints(mesh.points, std::move(all));
  for (Index old = 0; old < mesh.vertexCount(); ++old)
  {
    if (first[at(old)] == old)
    {
      const Index point = target.mesh.addPoint(mesh.points[at(old)]);
      target.mesh.addFace({ point, point, point });
      target.oldNumber.push_back(old);
    }
  }
  return target;
}

/// Drops triangles whose corners another one has, in any order.
void dropDuplicates(SurfaceMesh& mesh, std::vector<Index>& oldFace)
{
  std::vector<std::array<Index, 3>> corners(at(mesh.faceCount()));
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    corners[at(face)] = { mesh.faceVertex(face, 0), mesh.faceVertex(face, 1),
      mesh.faceVertex(face, 2) };
    std::sort(corners[at(face)].begin(), corners[at(face)].end());
  }
  const std::vector<Index> kept = firstOfEqual(corners);
  if (kept.size() == corners.size())
  {
    return;
  }
  SurfaceMesh unique;
  unique.points = std::move(mesh.points);
  std::vector<Index> oldOfUnique;
  for (const Index face : kept)
  {
    unique.addFace(
      { mesh.faceVertex(face, 0), mesh.faceVertex(face, 1), mesh.faceVertex(face, 2) });
    oldOfUnique.push_back(oldFace[at(face)]);
  }
  mesh = std::move(unique);
  oldFace = std::move(oldOfUnique);
}

} // namespace

SurfaceMesh uniqueTriangles(
  const SurfaceMesh& mesh, std::vector<Index>& oldFace, const Execution& execution)
{
  std::vector<Index> oldOfWelded;
  const SurfaceMesh welded = weldCoincidentPoints(mesh, nullptr, &oldOfWelded);
  if (welded.faceCount() == 0)
  {
    std::ostringstream message;
    message << "None of the " << mesh.faceCount()
            << " faces has three different corners, so there is no surface to measure from; "
               "check the mesh, or pass its points alone for the distance to them.";
    throw InputError(message.str());
  }
  execution.report(0.4);
  SurfaceMesh triangles = triangulate(welded, oldFace, execution.phase(0.4, 0.5));
  for (Index& face : oldFace)
  {
    face = oldOfWelded[at(face)];
  }
  execution.report(0.5);
  dropDuplicates(triangles, oldFace);
  execution.report(0.7);
  return triangles;
}

DistanceTarget makeDistanceTarget(const SurfaceMesh& mesh, const Execution& execution)
{
  validate(mesh);
  if (mesh.points.empty())
  {
    throw InputError("The mesh has no points, expected a surface or points to measure from; "
                     "check what produces it.");
  }
  DistanceTarget target;
  if (mesh.faceCount() == 0)
  {
    target = targetOfPoints(mesh);
  }
  else
  {
    target.mesh = uniqueTriangles(mesh, target.oldNumber, execution);
  }
  const Box box = boundingBox(target.mesh);
  requireSizeForFloats(box);
  target.center = box.center();
  for (Vec3& point : target.mesh.points)
  {
    point -= target.center;
  }
  if (!target.isPointSet)
  {
    target.orientation = orientOutwards(target.mesh);
  }
  return target;
}

} // namespace evolving
