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

/// The corner of a face and its two neighbours, of points that are looked up by the place in it.
struct Corner
{
  Vec3 toNext;
  Vec3 toPrevious;

  template <typename Points>
  Corner(const Points& pointAt, Index size, Index k)
  {
    const Vec3 own = pointAt(k);
    this->toNext = pointAt((k + 1) % size) - own;
    this->toPrevious = pointAt((k + size - 1) % size) - own;
  }
  Vec3 normal() const { return this->toNext.cross(this->toPrevious); }
  double cotangent() const { return cotangentBetween(this->toNext, this->toPrevious); }
};

/// A face before a move and after it.
template <typename Before, typename After>
bool isSpoiledFace(
  Index size, const Before& before, const After& after, const Vec3& upward, double largestCotangent)
{
  Vec3 normal = Vec3::Zero();
  Vec3 normalNow = Vec3::Zero();
  for (Index k = 0; k < size; ++k)
  {
    normal += Corner(before, size, k).normal();
    normalNow += Corner(after, size, k).normal();
  }
  if (normal.dot(upward) > 0.0 && !(normalNow.dot(upward) > 0.0))
  {
    return true;
  }
  double sharpestBefore = -std::numeric_limits<double>::infinity();
  double sharpest = sharpestBefore;
  for (Index k = 0; k < size; ++k)
  {
    const Corner old(before, size, k);
    const Corner now(after, size, k);
    if (old.normal().dot(normal) > 0.0 && !(now.normal().dot(normal) > 0.0))
    {
      return true;
    }
    sharpestBefore = std::max(sharpestBefore, old.cotangent());
    sharpest = std::max(sharpest, now.cotangent());
  }
  return sharpest > std::max(sharpestBefore, largestCotangent);
}

Vec3 upwardOf(const SurfaceMesh& mesh, const std::vector<Vec3>& normals, Index face)
{
  Vec3 upward = Vec3::Zero();
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    upward += normals[at(mesh.faceVertex(face, k))];
  }
  return upward;
}

} // namespace

SpoiledElements::SpoiledElements(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
  const std::vector<Vec3>& normals, double smallestAngle)
  : Mesh(mesh)
  , Before(before)
  , Normals(normals)
  , LargestCotangent(1.0 / std::tan(smallestAngle * RadiansPerDegree))
{
}

bool SpoiledElements::isSpoiled(Index face) const
{
  return isSpoiledFace(
    this->Mesh.faceSize(face),
    [&](Index k) -> const Vec3& { return this->Before[at(this->Mesh.faceVertex(face, k))]; },
    [&](Index k) -> const Vec3& { return this->Mesh.facePoint(face, k); },
    upwardOf(this->Mesh, this->Normals, face), this->LargestCotangent);
}

bool SpoiledElements::isSpoiledBy(Index face, Index moving) const
{
  const auto before = [&](Index k) -> const Vec3&
  { return this->Before[at(this->Mesh.faceVertex(face, k))]; };
  return isSpoiledFace(
    this->Mesh.faceSize(face), before,
    [&](Index k) -> const Vec3& { return k == moving ? this->Mesh.facePoint(face, k) : before(k); },
    upwardOf(this->Mesh, this->Normals, face), this->LargestCotangent);
}

std::vector<char> spoiledElements(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
  const std::vector<Vec3>& normals, double smallestAngle, const Execution& execution)
{
  const SpoiledElements elements(mesh, before, normals, smallestAngle);
  std::vector<char> spoiled(at(mesh.faceCount()));
  forEachIndex(
    execution, mesh.faceCount(), [&](Index face) { spoiled[at(face)] = elements.isSpoiled(face); });
  return spoiled;
}

} // namespace evolving
