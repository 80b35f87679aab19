// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/DartCharts.h"

#include "Features/ChartBorders.h"
#include "Features/ChartMerging.h"
#include "Features/DartSides.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

namespace evolving
{

namespace
{

Vec3 centroid(const TargetTriangles& target, Index face)
{
  const SurfaceMesh& mesh = target.mesh();
  return (mesh.facePoint(face, 0) + mesh.facePoint(face, 1) + mesh.facePoint(face, 2)) / 3.0;
}

/// The way between the centroids of two triangles over the middle of an edge; up to ten times as
/// long over a fold, so that charts meet there.
double stepLength(
  const TargetTriangles& target, const SharpEdges& sharp, Index from, Index to, Index edge)
{
  constexpr double Climb = 9.0;
  const auto [a, b] = target.edgeVertices(edge);
  const Vec3 middle = 0.5 * (target.point(a) + target.point(b));
  const double way =
    (centroid(target, from) - middle).norm() + (centroid(target, to) - middle).norm();
  return way * (1.0 + Climb * sharp.relativeFold(edge));
}

/**
 * Every triangle that a seed reaches takes the nearest one's name; the others keep theirs.
 * @param reach the longest way
 * @return the way from there; longer than the reach for the others
 */
std::vector<double> growCharts(const TargetTriangles& target, const SharpEdges& sharp,
  const std::vector<Index>& seeds, double reach, std::vector<Index>& names)
{
  using Arrival = std::tuple<double, Index, Index>; // way, triangle, name: the order of arrival
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> arrivals;
  std::vector<char> hasArrived(names.size(), 0);
  std::vector<double> way(names.size(), std::numeric_limits<double>::infinity());
  for (const Index seed : seeds)
  {
    way[at(seed)] = 0.0;
    arrivals.emplace(0.0, seed, names[at(seed)]);
  }
  while (!arrivals.empty())
  {
    const auto [length, face, name] = arrivals.top();
    arrivals.pop();
    if (length > way[at(face)] || hasArrived[at(face)] != 0)
    {
      continue;
    }
    hasArrived[at(face)] = 1;
    names[at(face)] = name;
    const auto goOn = [&, length = length, face = face, name = name](Index next, Index edge)
    {
      const double further = length + stepLength(target, sharp, face, next, edge);
      if (further < way[at(next)] && further <= reach)
      {
        way[at(next)] = further;
        arrivals.emplace(further, next, name);
      }
    };
    forEachSmoothNeighbour(target, sharp, face, goOn);
  }
  return way;
}

/// Charts by a triangle of each: around the seeds, and what is left of the patches beyond a reach.
std::vector<double> makeCharts(const TargetTriangles& target, const SharpEdges& sharp,
  DartSides& sides, double reach, std::vector<Index>& names)
{
  constexpr Index Beyond = NoIndex;
  names.assign(at(target.mesh().faceCount()), Beyond);
  for (const Index seed : sides.seeds())
  {
    names[at(seed)] = sides.sets().find(seed);
  }
  std::vector<double> way = growCharts(target, sharp, sides.seeds(), reach, names);
  const TriangleLabels pieces = connectedSets(target, sharp, names);
  std::vector<Index> firstOfPiece(at(pieces.count), NoIndex);
  for (Index face = 0; face < target.mesh().faceCount(); ++face)
  {
    Index& first = firstOfPiece[at(pieces[face])];
    first = first == NoIndex ? face : first;
    names[at(face)] = names[at(face)] == Beyond ? first : names[at(face)];
  }
  return way;
}

} // namespace

TriangleLabels separatingLabels(const TargetTriangles& target, const SharpEdges& sharp,
  const TriangleLabels& patches, double width)
{
  DartSides sides(target, sharp, patches);
  if (sides.seeds().empty())
  {
    return patches;
  }
  // A strip beside a dart ends well before this, and so does any border that is shorter.
  const double reach = 2.0 * sides.longestDart() + 3.0 * width;
  std::vector<Index> names;
  const std::vector<double> way = makeCharts(target, sharp, sides, reach, names);
  mergeCharts(target, sharp, sides.sets(), names);
  std::vector<char> isFixed(way.size());
  std::transform(way.begin(), way.end(), isFixed.begin(),
    [=](double length) { return length <= width || length > reach; });
  improveBorders(target, sharp, isFixed, names);
  return connectedSets(target, sharp, names);
}

} // namespace evolving
