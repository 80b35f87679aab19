// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/PolygonTriangulation.h"

#include "Mesh/EarClipping.h"

namespace evolving
{

namespace
{

/// Between two looks at whether to stop: far less than a second.
constexpr int TrianglesAtOnce = 1024;

std::vector<Vec3> cornersOf(const SurfaceMesh& mesh, Index face)
{
  std::vector<Vec3> corners;
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    corners.push_back(mesh.facePoint(face, k));
  }
  return corners;
}

} // namespace

std::vector<std::array<Index, 3>> triangulatePolygon(
  const std::vector<Vec3>& corners, const Execution& execution)
{
  std::vector<std::array<Index, 3>> triangles;
  if (corners.size() < 3)
  {
    return triangles;
  }
  triangles.reserve(corners.size() - 2);
  EarClipping polygon(corners);
  while (triangles.size() < corners.size() - 2)
  {
    triangles.push_back(polygon.clip());
    if (triangles.size() % TrianglesAtOnce == 0)
    {
      execution.report(static_cast<double>(triangles.size()) / static_cast<double>(corners.size()));
    }
  }
  return triangles;
}

SurfaceMesh triangulate(
  const SurfaceMesh& mesh, std::vector<Index>& oldFace, const Execution& execution)
{
  SurfaceMesh triangles;
  triangles.points = mesh.points;
  triangles.cornerVertices.reserve(mesh.cornerVertices.size());
  triangles.faceOffsets.reserve(mesh.faceOffsets.size());
  oldFace.clear();
  Index next = TrianglesAtOnce;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    const double begin = static_cast<double>(face) / mesh.faceCount();
    const double end = static_cast<double>(face + 1) / mesh.faceCount();
    if (triangles.faceCount() >= next)
    {
      execution.report(begin);
      next = triangles.faceCount() + TrianglesAtOnce;
    }
    if (mesh.faceSize(face) == 3)
    {
      triangles.addFace(
        { mesh.faceVertex(face, 0), mesh.faceVertex(face, 1), mesh.faceVertex(face, 2) });
      oldFace.push_back(face);
      continue;
    }
    for (const auto& triangle :
      triangulatePolygon(cornersOf(mesh, face), execution.phase(begin, end)))
    {
      triangles.addFace({ mesh.faceVertex(face, triangle[0]), mesh.faceVertex(face, triangle[1]),
        mesh.faceVertex(face, triangle[2]) });
      oldFace.push_back(face);
    }
  }
  return triangles;
}

} // namespace evolving
