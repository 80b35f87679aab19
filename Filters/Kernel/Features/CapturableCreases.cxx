// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/CapturableCreases.h"

#include "Features/DistinctCreases.h"
#include "Features/FacetedParts.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>

namespace evolving
{

namespace
{

/// Over that of creases: facets fold less than the sides of a machined part, and a ridge of 30
/// degrees is seen.
constexpr double SeenFold = 2.0 / 3.0;
/// Over that which is seen: facets that are rounded by less fold as they should to some degrees.
constexpr double FaintFold = 1.0 / 6.0;
/// In degrees: half of the least corner of a patch that two elements may share, 72.
constexpr double LeastWedge = 36.0;

/// Leaves out the sharp edges of triangles that are excluded.
void exclude(const TargetTriangles& target, const std::vector<char>& isExcluded, SharpEdges& sharp)
{
  for (const Index edge : sharp.list())
  {
    const TriangleEdges& edges = target.edges();
    if (std::any_of(edges.begin(edge), edges.end(edge),
          [&](Index corner) { return isExcluded[at(TargetTriangles::faceOf(corner))] != 0; }))
    {
      sharp.leaveOut(edge);
    }
  }
}

} // namespace

double lengthOf(const TargetTriangles& target, const std::vector<Index>& edges)
{
  double length = 0.0;
  for (const Index edge : edges)
  {
    length += target.edgeLength(edge);
  }
  return length;
}

std::vector<char> excludedTriangles(const TargetTriangles& target, const FeatureOptions& options)
{
  const SurfaceMesh& mesh = target.mesh();
  std::vector<char> isExcluded(at(mesh.faceCount()), 0);
  for (Index f = 0; options.isExcluded && f < mesh.faceCount(); ++f)
  {
    isExcluded[at(f)] = options.isExcluded(triangleOf(mesh, f).centroid());
  }
  return isExcluded;
}

OmittedCreases omittedOf(
  const TargetTriangles& target, const std::vector<Index>& edges, const SharpEdges& sharp)
{
  OmittedCreases creases;
  for (const Index edge : edges)
  {
    if (!sharp.isSharp(edge))
    {
      creases.length += target.edgeLength(edge);
      const auto [a, b] = target.edgeVertices(edge);
      creases.place = 0.5 * (target.point(a) + target.point(b));
    }
  }
  return creases;
}

SharpEdges capturableCreases(const TargetTriangles& target, const FeatureOptions& options,
  const std::vector<char>& isExcluded, OmittedCreases& excluded, const Execution& execution)
{
  SharpEdges sharp(target, options.angle, options.withBoundary, execution);
  if (options.onlyDistinct)
  {
    keepDistinctCreases(target, sharp);
    if (options.facetLength > 0.0)
    {
      const double seen = SeenFold * options.angle;
      takeFacetEdges(target, sharp, { seen, FaintFold * seen, LeastWedge }, options.facetLength);
    }
  }
  const std::vector<Index> all = sharp.list();
  exclude(target, isExcluded, sharp);
  excluded = omittedOf(target, all, sharp);
  return sharp;
}

} // namespace evolving
