// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/StepLimiter.h"

#include "Errors.h"
#include "Evolution/ParallelLoops.h"

#include <algorithm>
#include <sstream>

namespace evolving
{

namespace
{

/// Moves are halved this often before they are given up.
constexpr int MostHalvings = 5;
/// A vertex that waits may turn its neighbours' faces over, so waiting spreads, but not far.
constexpr int MostRounds = 100;

/// In units of a face's longest edge squared: below, rounding decides where its normal points.
constexpr double SmallestRelativeArea = 1e-10;

/// Half the sum of the cross products around a face: its area times its normal.
Vec3 vectorArea(const SurfaceMesh& faces, const std::vector<Vec3>& points, Index face)
{
  const Vec3& origin = points[at(faces.faceVertex(face, 0))];
  Vec3 sum = Vec3::Zero();
  for (Index k = 2; k < faces.faceSize(face); ++k)
  {
    sum += (points[at(faces.faceVertex(face, k - 1))] - origin)
             .cross(points[at(faces.faceVertex(face, k))] - origin);
  }
  return 0.5 * sum;
}

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

[[noreturn]] void throwTurned(Index turned, const SurfaceMesh& mesh)
{
  std::ostringstream message;
  message << turned << " of " << mesh.faceCount()
          << " faces turned over in one step, expected at most a tenth; use a shorter time step "
             "or a weaker redistribution.";
  throw SolverError(message.str());
}

} // namespace

StepLimiter::StepLimiter(
  const SurfaceMesh& start, const std::vector<Vec3>& normals, const VanishedComponents& vanished)
  : Vanished(vanished)
  , MayTurn(at(start.faceCount()))
{
  for (Index face = 0; face < start.faceCount(); ++face)
  {
    this->MayTurn[at(face)] = !facesOutwards(start, normals, face);
  }
}

bool StepLimiter::isTurned(
  const SurfaceMesh& mesh, const std::vector<Vec3>& before, Index face) const
{
  return !this->MayTurn[at(face)] &&
    vectorArea(mesh, mesh.points, face).dot(vectorArea(mesh, before, face)) < 0.0 &&
    !this->Vanished.contain(mesh.faceVertex(face, 0));
}

Index StepLimiter::countTurned(
  const SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution) const
{
  return static_cast<Index>(sumEachIndex(execution, mesh.faceCount(),
    [&](Index face) { return this->isTurned(mesh, before, face) ? 1.0 : 0.0; }));
}

/// One flag per vertex.
std::vector<char> StepLimiter::verticesOfTurned(
  const SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution) const
{
  std::vector<char> turned(at(mesh.faceCount()));
  forEachIndex(execution, mesh.faceCount(),
    [&](Index face) { turned[at(face)] = this->isTurned(mesh, before, face); });
  std::vector<char> flags(mesh.points.size(), 0);
  for (Index face = 0; face < mesh.faceCount(); ++face)
  {
    for (Index k = 0; turned[at(face)] && k < mesh.faceSize(face); ++k)
    {
      flags[at(mesh.faceVertex(face, k))] = 1;
    }
  }
  return flags;
}

Index StepLimiter::limit(const SurfaceMesh& mesh, const std::vector<Vec3>& before,
  const PlaceVertices& place, const Execution& execution) const
{
  Index turned = this->countTurned(mesh, before, execution);
  if (turned > LargestTurnedPart * mesh.faceCount())
  {
    throwTurned(turned, mesh);
  }
  std::vector<double> fraction(turned > 0 ? mesh.points.size() : 0, 1.0);
  for (int round = 0; turned > 0; ++round)
  {
    if (round == MostRounds)
    {
      throwTurned(turned, mesh);
    }
    const std::vector<char> flags = this->verticesOfTurned(mesh, before, execution);
    for (std::size_t i = 0; i < flags.size(); ++i)
    {
      fraction[i] *= !flags[i] ? 1.0 : round < MostHalvings ? 0.5 : 0.0;
    }
    place(fraction);
    turned = this->countTurned(mesh, before, execution);
  }
  return static_cast<Index>(
    std::count_if(fraction.begin(), fraction.end(), [](double part) { return part < 1.0; }));
}

} // namespace evolving
