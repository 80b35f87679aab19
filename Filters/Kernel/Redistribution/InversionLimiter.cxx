// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Redistribution/InversionLimiter.h"

#include "Errors.h"
#include "ParallelLoops.h"
#include "Redistribution/InversionRemedies.h"

#include <algorithm>
#include <sstream>

namespace evolving
{

namespace
{

/// Elements are reshaped this often before moves are made alike.
constexpr int ReshapingRounds = 8;
/// Moves are made alike this often before they are halved.
constexpr int EveningRounds = 8;
/// Moves are halved this often before they are given up.
constexpr int MostHalvings = 5;
/// A vertex that waits may turn its neighbours' faces over, so waiting spreads, but not far.
constexpr int MostRounds = 100;

/// In units of a face's longest edge squared: below, rounding decides where its normal points.
constexpr double SmallestRelativeArea = 1e-10;

/// Does a face face outwards?
bool facesOutwards(const SurfaceMesh& mesh, const std::vector<Vec3>& normals, Index face)
{
  Vec3 normal = Vec3::Zero();
  double longest = 0.0;
  for (Index k = 0; k < mesh.faceSize(face); ++k)
  {
    normal += normals[at(mesh.faceVertex(face, k))];
    const Vec3 edge = mesh.facePoint(face, (k + 1) % mesh.faceSize(face)) - mesh.facePoint(face, k);
    longest = std::max(longest, edge.squaredNorm());
  }
  return faceVectorArea(mesh, face).dot(normal) > SmallestRelativeArea * longest;
}

[[noreturn]] void throwTurned(std::size_t turned, const SurfaceMesh& mesh)
{
  std::ostringstream message;
  message << turned << " of " << mesh.faceCount()
          << " faces turned over in one step, expected at most a fifth; use a shorter time step.";
  throw SolverError(message.str());
}

} // namespace

InversionLimiter::InversionLimiter(const SurfaceMesh& start, const MeshTopology& topology,
  const std::vector<Vec3>& normals, const VanishedComponents& vanished)
  : Topology(topology)
  , Vanished(vanished)
  , MayTurn(at(start.faceCount()))
{
  for (Index face = 0; face < start.faceCount(); ++face)
  {
    this->MayTurn[at(face)] = !facesOutwards(start, normals, face);
  }
}

bool InversionLimiter::isTurned(
  const SurfaceMesh& mesh, const std::vector<Vec3>& before, Index face) const
{
  return faceVectorArea(mesh, face).dot(faceVectorArea(mesh, before, face)) < 0.0 &&
    !this->MayTurn[at(face)] && !this->Vanished.contain(mesh.faceVertex(face, 0));
}

std::vector<Index> InversionLimiter::turnedFaces(
  const SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution) const
{
  std::vector<char> flags(at(mesh.faceCount()));
  forEachIndex(execution, mesh.faceCount(),
    [&](Index face) { flags[at(face)] = this->isTurned(mesh, before, face); });
  std::vector<Index> turned;
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    if (flags[at(face)])
    {
      turned.push_back(face);
    }
  }
  return turned;
}

void InversionLimiter::limit(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
  const std::vector<Vec3>& normals, LimitedMove& move, const PlaceVertices& place,
  const Execution& execution) const
{
  std::vector<Index> turned = this->turnedFaces(mesh, before, execution);
  if (static_cast<double>(turned.size()) > LargestTurnedPart * mesh.faceCount())
  {
    throwTurned(turned.size(), mesh);
  }
  move.fraction.assign(mesh.points.size(), 1.0);
  for (int round = 0; !turned.empty(); ++round)
  {
    if (round == MostRounds)
    {
      throwTurned(turned.size(), mesh);
    }
    if (round < ReshapingRounds)
    {
      reshape(mesh, this->Topology, normals, turned, move.displacement);
    }
    else if (round < ReshapingRounds + EveningRounds)
    {
      evenOut(mesh, turned, move.displacement);
    }
    else
    {
      shorten(mesh, turned, round < ReshapingRounds + EveningRounds + MostHalvings ? 0.5 : 0.0,
        move.fraction);
    }
    place();
    turned = this->turnedFaces(mesh, before, execution);
  }
}

} // namespace evolving
