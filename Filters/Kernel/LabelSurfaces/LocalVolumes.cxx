// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LocalVolumes.h"

#include "Algebra/ConjugateGradients.h"
#include "ParallelLoops.h"

#include <Eigen/Dense>

namespace evolving
{

namespace
{

/// What two rounds leave out is what is no longer than the length itself.
constexpr int Rounds = 2;
constexpr double Tolerance = 1e-3;
/// Of the least squares where sheets meet, beside a unit for each neighbour: directions that no
/// neighbour speaks for stay.
constexpr double Damping = 0.3;
/// Of an area in voxels' faces: below it sheets lie back to back and have no volume to give.
constexpr double SmallestArea = 1e-9;

bool isSheet(const InterfaceNet& net, Index vertex)
{
  return net.kinds[at(vertex)] == VertexKind::Sheet;
}

/// Does a vertex lie on a curve in a side of the image? The voxels' corners there lie to both sides
/// of the outline of what is cut off. Within the image curves have none that do, where three labels
/// meet in wedges, and follow the sheets.
bool isOutline(const InterfaceNet& net, Index vertex)
{
  return !isSheet(net, vertex) && net.fixed[at(vertex)] != 0;
}

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

/// The move of a vertex where sheets meet: what takes it along with the vertices beside it.
Vec3 moveAlongNeighbours(const InterfaceNet& net, Index vertex, const std::vector<Vec3>& normals,
  const std::vector<Vec3>& moves)
{
  Eigen::Matrix3d matrix = Damping * Eigen::Matrix3d::Identity();
  Vec3 sum = Vec3::Zero();
  for (Index edge = net.edgeOffsets[at(vertex)]; edge < net.edgeOffsets[at(vertex) + 1]; ++edge)
  {
    const Index other = net.edgeEnds[at(edge)];
    if (isSheet(net, other))
    {
      matrix += normals[at(other)] * normals[at(other)].transpose();
      sum += moves[at(other)];
    }
  }
  return matrix.ldlt().solve(sum);
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
  std::vector<Vec3> moves(points.size());
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
        const Vec3& sums = smoothed[at(i)];
        moves[at(i)] = sums;
        if (isSheet(this->Net, i))
        {
          const double height = sums[1] > SmallestArea ? sums[0] / sums[1] : 0.0;
          moves[at(i)] = height * normals[at(i)];
        }
      });
    forEachIndex(execution, this->Net.vertexCount(),
      [&](Index i)
      {
        Vec3 move = isSheet(this->Net, i) || isOutline(this->Net, i)
          ? moves[at(i)]
          : moveAlongNeighbours(this->Net, i, normals, moves);
        keepFixed(this->Net, i, move);
        points[at(i)] += move;
      });
  }
}

} // namespace evolving
