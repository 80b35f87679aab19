// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Operators/SpoiledElements.h"

#include "Mesh/Angles.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

/// The corner of a face and its two neighbours at given points.
struct Corner
{
  Vec3 toNext;
  Vec3 toPrevious;

  Corner(const SurfaceMesh& faces, const std::vector<Vec3>& points, Index face, Index k)
  {
    const Index size = faces.faceSize(face);
    const Vec3& own = points[at(faces.faceVertex(face, k))];
    this->toNext = points[at(faces.faceVertex(face, (k + 1) % size))] - own;
    this->toPrevious = points[at(faces.faceVertex(face, (k + size - 1) % size))] - own;
  }
  Vec3 normal() const { return this->toNext.cross(this->toPrevious); }
  double cotangent() const { return cotangentBetween(this->toNext, this->toPrevious); }
};

bool isSpoiled(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
  const std::vector<Vec3>& normals, double largestCotangent, Index face)
{
  Vec3 normal = Vec3::Zero();
  Vec3 normalNow = Vec3::Zero();
  Vec3 upward = Vec3::Zero();
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    normal += Corner(mesh, before, face, k).normal();
    normalNow += Corner(mesh, mesh.points, face, k).normal();
    upward += normals[at(mesh.faceVertex(face, k))];
  }
  if (normal.dot(upward) > 0.0 && !(normalNow.dot(upward) > 0.0))
  {
    return true;
  }
  double sharpestBefore = -std::numeric_limits<double>::infinity();
  double sharpest = sharpestBefore;
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    const Corner old(mesh, before, face, k);
    const Corner now(mesh, mesh.points, face, k);
    if (old.normal().dot(normal) > 0.0 && !(now.normal().dot(normal) > 0.0))
    {
      return true;
    }
    sharpestBefore = std::max(sharpestBefore, old.cotangent());
    sharpest = std::max(sharpest, now.cotangent());
  }
  return sharpest > std::max(sharpestBefore, largestCotangent);
}

} // namespace

std::vector<char> spoiledElements(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
  const std::vector<Vec3>& normals, double smallestAngle, const Execution& execution)
{
  const double largestCotangent = 1.0 / std::tan(smallestAngle * RadiansPerDegree);
  std::vector<char> spoiled(at(mesh.faceCount()));
  forEachIndex(execution, mesh.faceCount(),
    [&](Index face)
    { spoiled[at(face)] = isSpoiled(mesh, before, normals, largestCotangent, face); });
  return spoiled;
}

} // namespace evolving
