// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/ElementImprovement.h"

#include "Mesh/Angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

using Corners = EditableInterfaces::Corners;

constexpr int Rounds = 6;
/// Sines of smallest angles: elements below are tried to be bettered by other edges, by sliding.
constexpr double GoodEnough = 0.6;
constexpr double GoodToSlide = 0.7;
/// What differs by less is equal, and the first one counts: then rounding does not decide.
constexpr double Equal = 1e-6;
/// A change has to better the worst element by this, or they would go on for ever.
constexpr double LeastGain = 1e-3;
/// Of the mean edge at a vertex: first and last step of the search for a better place.
constexpr double FirstStep = 0.25;
constexpr double LastStep = 0.03;
/// A collapse may turn an element by 37 degrees, that of a short edge by 60, and take a curve aside
/// by a tenth of a voxel.
constexpr double LeastCosine = 0.8;
constexpr double LeastCosineOfShort = 0.5;
constexpr double CurveTolerance = 0.1;
/// Of a voxel: what is shorter may be drawn together even where that takes a corner off a sheet.
constexpr double ShortEdge = 0.25;

} // namespace

ElementImprovement::ElementImprovement(EditableInterfaces& mesh, Limit limit)
  : Mesh(mesh)
  , IsAllowed(std::move(limit))
  , Elements(mesh)
{
}

/// Eight of them in the tangent plane of a sheet, two along a curve.
std::vector<Vec3> ElementImprovement::directions(Index vertex) const
{
  std::vector<Vec3> found;
  if (this->Mesh.kind(vertex) == VertexKind::Sheet)
  {
    const Vec3 normal = this->Elements.normalAt(vertex);
    const Vec3 u = normal.unitOrthogonal();
    const Vec3 v = normal.cross(u);
    for (int i = 0; i < 8; ++i)
    {
      found.emplace_back(std::cos(0.25 * Pi * i) * u + std::sin(0.25 * Pi * i) * v);
    }
  }
  else if (this->Mesh.kind(vertex) == VertexKind::Curve)
  {
    for (const Index other : this->Mesh.curveNeighbors(vertex))
    {
      found.emplace_back(directionOf(this->Mesh.place(other) - this->Mesh.place(vertex)));
    }
  }
  return found;
}

void ElementImprovement::slide(Index vertex)
{
  if (!this->Mesh.isUsed(vertex) || !this->Mesh.isFree(vertex))
  {
    return;
  }
  double best = this->Elements.worst(vertex);
  if (best > GoodToSlide)
  {
    return;
  }
  const std::vector<Vec3> ways = this->directions(vertex);
  const std::vector<Index> others = this->Mesh.neighbors(vertex);
  double mean = 0.0;
  for (const Index other : others)
  {
    mean += (this->Mesh.place(other) - this->Mesh.place(vertex)).norm();
  }
  mean /= static_cast<double>(others.size());
  for (double step = FirstStep; step > LastStep; step *= 0.5)
  {
    const Vec3 from = this->Mesh.place(vertex);
    for (const Vec3& way : ways)
    {
      const Vec3 place = from + step * mean * way;
      const double reached = this->Elements.worst(vertex, place);
      if (reached > best + LeastGain && this->IsAllowed(this->Mesh.netVertex(vertex), place))
      {
        best = reached;
        this->Mesh.move(vertex, place);
      }
    }
  }
}

/// Does a vertex of a curve lie on what its collapse leaves of it?
bool ElementImprovement::isFlat(Index from, Index to) const
{
  const double length = (this->Mesh.place(to) - this->Mesh.place(from)).norm();
  if (!this->Mesh.isOwnEdge(from, to))
  {
    return length < ShortEdge;
  }
  if (this->Mesh.kind(from) != VertexKind::Curve)
  {
    return true;
  }
  for (const Index other : this->Mesh.curveNeighbors(from))
  {
    if (other != to)
    {
      const Vec3 way = directionOf(this->Mesh.place(to) - this->Mesh.place(other));
      const Vec3 d = this->Mesh.place(from) - this->Mesh.place(other);
      if ((d - d.dot(way) * way).norm() > CurveTolerance)
      {
        return false;
      }
    }
  }
  return true;
}

/// How much better the worst element gets, of those that change; negative where one turns over.
double ElementImprovement::gainOfCollapse(Index from, Index to) const
{
  const bool isShort = (this->Mesh.place(to) - this->Mesh.place(from)).norm() < ShortEdge;
  const double leastCosine = isShort ? LeastCosineOfShort : LeastCosine;
  double reached = 1.0;
  for (const Index triangle : this->Mesh.star(from))
  {
    Corners corners = this->Mesh.corners(triangle);
    if (EditableInterfaces::hasCorner(corners, to))
    {
      continue;
    }
    std::replace(corners.begin(), corners.end(), from, to);
    const Vec3& a = this->Mesh.place(corners[0]);
    const Vec3 normal =
      directionOf((this->Mesh.place(corners[1]) - a).cross(this->Mesh.place(corners[2]) - a));
    if (normal.dot(this->Elements.normal(triangle)) < leastCosine)
    {
      return -1.0;
    }
    reached = std::min(reached, this->Elements.quality(corners, this->Elements.normal(triangle)));
  }
  return reached - this->Elements.worst(from);
}

bool ElementImprovement::collapseOne(Index triangle)
{
  const Corners corners = this->Mesh.corners(triangle);
  double best = LeastGain;
  std::array<Index, 2> ends = { NoIndex, NoIndex };
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (const std::size_t next : { (k + 1) % 3, (k + 2) % 3 })
    {
      const double gain = this->gainOfCollapse(corners[k], corners[next]);
      if (gain > best + Equal && this->isFlat(corners[k], corners[next]) &&
        this->Mesh.canCollapse(corners[k], corners[next]))
      {
        best = gain;
        ends = { corners[k], corners[next] };
      }
    }
  }
  if (ends[0] == NoIndex)
  {
    return false;
  }
  this->Mesh.collapse(ends[0], ends[1]);
  return true;
}

bool ElementImprovement::flipLongest(Index triangle)
{
  const Corners corners = this->Mesh.corners(triangle);
  std::size_t longest = 0;
  double most = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double length =
      (this->Mesh.place(corners[k]) - this->Mesh.place(corners[(k + 1) % 3])).norm();
    longest = length > most + Equal ? k : longest;
    most = std::max(most, length);
  }
  const Index a = corners[longest];
  const Index b = corners[(longest + 1) % 3];
  if (this->Mesh.flipEnds(a, b)[0] == NoIndex)
  {
    return false;
  }
  const std::vector<Index> both = this->Mesh.trianglesAt(a, b);
  const double before = std::min(this->Elements.quality(both[0]), this->Elements.quality(both[1]));
  const std::array<Index, 2> ends = this->Mesh.flipEnds(a, b);
  const Vec3 normal = directionOf(this->Elements.normal(both[0]) + this->Elements.normal(both[1]));
  this->Mesh.flip(a, b);
  if (std::min(this->Elements.quality(this->Mesh.corners(both[0]), normal),
        this->Elements.quality(this->Mesh.corners(both[1]), normal)) < before + LeastGain)
  {
    this->Mesh.flip(ends[0], ends[1]);
    return false;
  }
  this->Elements.setNormal(both[0], normal);
  this->Elements.setNormal(both[1], normal);
  return true;
}

void ElementImprovement::treat(Index triangle)
{
  if (this->Mesh.isAlive(triangle) && this->Elements.quality(triangle) < GoodEnough &&
    !this->flipLongest(triangle))
  {
    this->collapseOne(triangle);
  }
}

void ElementImprovement::run(const Execution& execution)
{
  for (int round = 0; round < Rounds; ++round)
  {
    execution.report(static_cast<double>(round) / Rounds);
    for (Index vertex = 0; vertex < this->Mesh.vertexCount(); ++vertex)
    {
      this->slide(vertex);
    }
    for (Index triangle = 0; triangle < this->Mesh.triangleCount() && round + 1 < Rounds;
         ++triangle)
    {
      this->treat(triangle);
    }
  }
}

} // namespace evolving
