// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/InterfaceFinish.h"

#include "LabelSurfaces/CornerOctants.h"
#include "LabelSurfaces/EditableInterfaces.h"
#include "LabelSurfaces/ElementImprovement.h"
#include "LabelSurfaces/LabelVolumes.h"
#include "Mesh/FloatPoints.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TriangleView.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace evolving
{

namespace
{

/// Rounds of taking intersecting triangles back by half their way, before they go all the way.
constexpr int HalvingRounds = 6;
/// As many in which volumes are restored; then only the way back is left.
constexpr int RestoringRounds = 20;

} // namespace

std::vector<Vec3> inSpace(
  const std::vector<Vec3>& points, const Eigen::Affine3d& toSpace, const Execution& execution)
{
  std::vector<Vec3> places(points.size());
  forEachIndex(execution, static_cast<std::int64_t>(points.size()),
    [&](Index i) { places[at(i)] = toSpace * points[at(i)]; });
  return places;
}

InterfaceFinish::InterfaceFinish(const MaterialGrid& grid, const InterfaceNet& net,
  NetLimits limits, const Eigen::Affine3d& toSpace, std::vector<double> volumes, bool areFloats)
  : Grid(grid)
  , Net(net)
  , Limits(std::move(limits))
  , ToSpace(toSpace)
  , Volumes(std::move(volumes))
  , AreFloats(areFloats)
{
}

InterfaceTriangles InterfaceFinish::run(std::vector<Vec3>& points, const Execution& execution)
{
  std::vector<Vec3> smooth = points;
  this->IsHeld.assign(points.size(), 0);
  this->Rests.assign(points.size(), 0);
  for (int round = 0;; ++round)
  {
    points = smooth;
    InterfaceTriangles triangles =
      splitNet(this->Net, inSpace(points, this->ToSpace, execution), execution);
    this->improve(triangles, points, execution.phase(0.0, 0.3));
    if (round <= RestoringRounds)
    {
      const LabelVolumes volumes(this->Net, triangles, this->Limits, this->Volumes);
      volumes.restore(this->Rests, points, execution.phase(0.3, 0.6));
    }
    std::vector<Vec3> places = inSpace(points, this->ToSpace, execution);
    places = this->AreFloats ? roundedToFloats(std::move(places)) : std::move(places);
    const auto pairs =
      selfIntersections(TriangleView(places, triangles.corners), execution.phase(0.6, 1.0));
    if (pairs.empty())
    {
      return triangles;
    }
    this->takeBack(pairs, triangles, round < HalvingRounds ? 0.5 : 0.0, smooth);
  }
}

/// In voxels as long and wide as they are in space, for it is there that angles count, wherever the
/// image lies and however it is turned.
void InterfaceFinish::improve(
  InterfaceTriangles& triangles, std::vector<Vec3>& points, const Execution& execution) const
{
  std::vector<char> isChosen(points.size());
  std::vector<char> isFree(points.size());
  std::vector<char> isPinched(points.size());
  std::vector<Vec3> places(points.size());
  Vec3 scale = this->ToSpace.linear().colwise().norm();
  scale /= std::cbrt(scale.prod());
  forEachIndex(execution, this->Net.vertexCount(),
    [&](Index i)
    {
      isChosen[at(i)] = this->Limits.isNearCurve(i) ? 1 : 0;
      isFree[at(i)] = isChosen[at(i)] != 0 && this->IsHeld[at(i)] == 0 ? 1 : 0;
      isPinched[at(i)] =
        isFree[at(i)] != 0 && meetsItself(this->Grid.around(this->Net.corners[at(i)])) ? 1 : 0;
      places[at(i)] = points[at(i)].cwiseProduct(scale);
    });
  EditableInterfaces mesh(this->Net, triangles, places, { isChosen, isFree, isPinched });
  ElementImprovement(mesh,
    [&](Index vertex, const Vec3& place)
    { return this->Limits.isAllowed(this->Net, vertex, place.cwiseQuotient(scale)); })
    .run(execution);
  mesh.writeTo(triangles, places);
  forEachIndex(execution, this->Net.vertexCount(),
    [&](Index i)
    {
      if (isFree[at(i)] != 0)
      {
        points[at(i)] = places[at(i)].cwiseQuotient(scale);
      }
    });
}

/// A vertex that slides gets its box, one that has that keeps its elements, and one that does rests
/// nearer to its corner: of two triangles those go back that have the least of this behind them.
int InterfaceFinish::stage(Index vertex) const
{
  return this->Limits.slides(vertex) ? 0 : this->IsHeld[at(vertex)] == 0 ? 1 : 2;
}

void InterfaceFinish::takeBack(const std::vector<std::pair<Index, Index>>& pairs,
  const InterfaceTriangles& triangles, double left, std::vector<Vec3>& points)
{
  std::vector<char> goesBack(points.size(), 0);
  for (const auto& [first, second] : pairs)
  {
    std::array<Index, 6> vertices{};
    std::copy_n(triangles.corners.begin() + 3 * first, 3, vertices.begin());
    std::copy_n(triangles.corners.begin() + 3 * second, 3, vertices.begin() + 3);
    const auto isBefore = [this](Index a, Index b) { return this->stage(a) < this->stage(b); };
    const int least = this->stage(*std::min_element(vertices.begin(), vertices.end(), isBefore));
    for (const Index i : vertices)
    {
      goesBack[at(i)] = this->stage(i) == least ? 1 : goesBack[at(i)];
    }
  }
  for (Index i = 0; i < this->Net.vertexCount(); ++i)
  {
    if (goesBack[at(i)] == 0)
    {
      continue;
    }
    const int stage = this->stage(i);
    const Vec3 corner = this->Net.cornerPoint(i);
    this->Limits.keepInBox(i);
    this->IsHeld[at(i)] = stage > 0 ? 1 : 0;
    this->Rests[at(i)] = stage > 1 ? 1 : 0;
    points[at(i)] = this->Limits.limited(
      this->Net, i, corner + (stage > 1 ? left : 1.0) * (points[at(i)] - corner));
  }
}

} // namespace evolving
