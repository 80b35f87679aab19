// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LocalVolumes.h"

#include "Algebra/ConjugateGradients.h"
#include "ParallelLoops.h"

namespace evolving
{

namespace
{

/// What two rounds leave out is what is no longer than the length itself.
constexpr int Rounds = 2;
constexpr double Tolerance = 1e-3;
/// Of an area in voxels' faces: below it sheets lie back to back and have no volume to give.
constexpr double SmallestArea = 1e-9;

/// Along sheets and along outlines, each without the other.
SparseMatrix smoothingMatrix(const InterfaceNet& net, double weight)
{
  SparseMatrix matrix(net.vertexCount(), net.vertexCount());
  matrix.reserve(static_cast<Index>(net.edgeEnds.size()) + net.vertexCount());
  for (Index i = 0; i < net.vertexCount(); ++i)
  {
    matrix.startVec(i);
    std::vector<Index> others;
    for (Index edge = net.edgeOffsets[at(i)]; edge < net.edgeOffsets[at(i) + 1]; ++edge)
    {
      const Index other = net.edgeEnds[at(edge)];
      const bool isWithinSheet = isSheet(net, i) && isSheet(net, other);
      const bool isWithinOutline =
        isOutline(net, i) && isOutline(net, other) && net.isJunction[at(edge)] != 0;
      if (isWithinSheet || isWithinOutline)
      {
        others.push_back(other);
      }
    }
    const double diagonal = 1.0 + weight * static_cast<double>(others.size());
    bool isDiagonalDone = false;
    for (const Index other : others)
    {
      if (other > i && !isDiagonalDone)
      {
        matrix.insertBack(i, i) = diagonal;
        isDiagonalDone = true;
      }
      matrix.insertBack(i, other) = -weight;
    }
    if (!isDiagonalDone)
    {
      matrix.insertBack(i, i) = diagonal;
    }
  }
  matrix.finalize();
  return matrix;
}

void keepFixed(const InterfaceNet& net, Index vertex, Vec3& move)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    move[axis] *= (net.fixed[at(vertex)] >> axis & 1U) != 0 ? 0.0 : 1.0;
  }
}

} // namespace

std::vector<Vec3> sheetAreas(
  const InterfaceNet& net, const std::vector<Vec3>& points, const Execution& execution)
{
  std::vector<Vec3> areas(points.size(), Vec3::Zero());
  forEachIndex(execution, net.vertexCount(),
    [&](Index i)
    {
      if (!isSheet(net, i))
      {
        return;
      }
      for (Index k = net.quadOffsets[at(i)]; k < net.quadOffsets[at(i) + 1]; ++k)
      {
        const Index quad = net.quadsOfVertices[at(k)];
        const std::array<Material, 2>& sides = net.quads[at(quad)].sides;
        areas[at(i)] += (sides[0] < sides[1] ? 0.25 : -0.25) * quadArea(net, points, quad);
      }
    });
  return areas;
}

std::vector<Vec3> directionsOf(std::vector<Vec3> areas, const Execution& execution)
{
  forEachIndex(execution, static_cast<std::int64_t>(areas.size()),
    [&areas](Index i)
    {
      const double length = areas[at(i)].norm();
      areas[at(i)] /= length > SmallestArea ? length : 1.0;
    });
  return areas;
}

LocalVolumes::LocalVolumes(const InterfaceNet& net, double length, const Execution&)
  : Net(net)
  , Smoothing(smoothingMatrix(net, 0.25 * length * length))
{
}

void LocalVolumes::giveBack(
  const std::vector<Vec3>& before, std::vector<Vec3>& points, const Execution& execution) const
{
  SolverLimits limits;
  limits.tolerance = Tolerance;
  std::vector<Vec3> smoothed(points.size(), Vec3::Zero());
  for (int round = 0; round < Rounds; ++round)
  {
    const std::vector<Vec3> areas = sheetAreas(this->Net, points, execution);
    const std::vector<Vec3> normals = directionsOf(areas, execution);
    // Of sheets volume and area at once, as the first two of three coordinates; of outlines moves.
    std::vector<Vec3> lost(points.size());
    forEachIndex(execution, this->Net.vertexCount(),
      [&](Index i)
      {
        const Vec3 move = before[at(i)] - points[at(i)];
        lost[at(i)] =
          isSheet(this->Net, i) ? Vec3(areas[at(i)].dot(move), areas[at(i)].norm(), 0.0) : move;
      });
    conjugateGradients(this->Smoothing, lost, smoothed, limits, execution);
    forEachIndex(execution, this->Net.vertexCount(),
      [&](Index i)
      {
        if (isInnerJunction(this->Net, i))
        {
          return;
        }
        const Vec3& sums = smoothed[at(i)];
        const double height = sums[1] > SmallestArea ? sums[0] / sums[1] : 0.0;
        Vec3 move = isSheet(this->Net, i) ? Vec3(height * normals[at(i)]) : sums;
        keepFixed(this->Net, i, move);
        points[at(i)] += move;
      });
  }
}

} // namespace evolving
