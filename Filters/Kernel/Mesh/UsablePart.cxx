// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/UsablePart.h"

#include <sstream>
#include <vector>

namespace evolving
{

namespace
{

enum class Damage
{
  None,
  NotFinite,
  TooFewCorners
};

Damage damageOfFace(const SurfaceMesh& mesh, Index face)
{
  if (mesh.faceSize(face) < 3)
  {
    return Damage::TooFewCorners;
  }
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    if (!mesh.facePoint(face, k).allFinite())
    {
      return Damage::NotFinite;
    }
  }
  return Damage::None;
}

/// Of a face, or of a point of a mesh without faces.
Damage damageOf(const SurfaceMesh& mesh, Index part)
{
  if (mesh.faceCount() > 0)
  {
    return damageOfFace(mesh, part);
  }
  return mesh.points[at(part)].allFinite() ? Damage::None : Damage::NotFinite;
}

} // namespace

DamagedParts findDamagedParts(const SurfaceMesh& mesh)
{
  DamagedParts damaged;
  const Index parts = mesh.faceCount() > 0 ? mesh.faceCount() : mesh.vertexCount();
  for (Index part = 0; part < parts; ++part)
  {
    const Damage damage = damageOf(mesh, part);
    damaged.notFinite += damage == Damage::NotFinite ? 1 : 0;
    damaged.tooFewCorners += damage == Damage::TooFewCorners ? 1 : 0;
    damaged.first = damaged.first == NoIndex && damage != Damage::None ? part : damaged.first;
  }
  return damaged;
}

SurfaceMesh withoutDamagedParts(const SurfaceMesh& mesh, std::vector<Index>* oldNumber)
{
  const auto note = [oldNumber](Index number)
  {
    if (oldNumber)
    {
      oldNumber->push_back(number);
    }
  };
  SurfaceMesh usable;
  if (mesh.faceCount() == 0)
  {
    for (Index v = 0; v < mesh.vertexCount(); ++v)
    {
      if (mesh.points[at(v)].allFinite())
      {
        usable.addPoint(mesh.points[at(v)]);
        note(v);
      }
    }
    return usable;
  }
  usable.points = mesh.points;
  std::vector<Index> corners;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (damageOfFace(mesh, face) == Damage::None)
    {
      const auto begin = mesh.cornerVertices.begin() + mesh.faceOffsets[at(face)];
      corners.assign(begin, begin + mesh.faceSize(face));
      usable.addFace(corners);
      note(face);
    }
  }
  return usable;
}

std::string describeLeftOut(
  const DamagedParts& damaged, const SurfaceMesh& mesh, const std::string& first)
{
  const bool areFaces = mesh.faceCount() > 0;
  std::ostringstream sentence;
  sentence << damaged.count() << " of the input's "
           << (areFaces ? mesh.faceCount() : mesh.vertexCount())
           << (areFaces ? " faces" : " points") << " were left out, the first of them " << first
           << ": " << damaged.notFinite << " with coordinates that are not finite";
  if (areFaces)
  {
    sentence << " and " << damaged.tooFewCorners << " with fewer than three corners";
  }
  sentence << "; repair them if they should count.";
  return sentence.str();
}

} // namespace evolving
