// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/ClosedSurfaces.h"

#include "LabelSurfaces/SurfacePasses.h"
#include "ParallelLoops.h"

#include <numeric>

namespace evolving
{

namespace
{

/// The places of numbered things in the order of their labels.
std::vector<Index> placesByLabel(const std::vector<Material>& labels)
{
  std::vector<Index> next(static_cast<std::size_t>(OutsideImage) + 1, 0);
  for (const Material label : labels)
  {
    ++next[static_cast<std::size_t>(label) + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Index> places(labels.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    places[i] = next[labels[i]]++;
  }
  return places;
}

/// The sides of triangles that are of labels, as 2 triangle + side, by label.
std::vector<Index> sidesByLabel(const InterfaceNet& net, const InterfaceTriangles& triangles)
{
  std::vector<Index> sides;
  std::vector<Material> labels;
  for (Index triangle = 0; triangle < triangles.count(); ++triangle)
  {
    const NetQuad& quad = net.quads[at(triangles.quads[at(triangle)])];
    for (const Index side : { 0, 1 })
    {
      if (isLabel(quad.sides[at(side)]))
      {
        sides.push_back(2 * triangle + side);
        labels.push_back(quad.sides[at(side)]);
      }
    }
  }
  const std::vector<Index> places = placesByLabel(labels);
  std::vector<Index> ordered(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    ordered[at(places[i])] = sides[i];
  }
  return ordered;
}

ClosedSurfaces surfacesOf(const InterfaceNet& net, const InterfaceTriangles& triangles,
  const std::vector<Vec3>& points, const SurfacePasses& passes, const Execution& execution)
{
  ClosedSurfaces surfaces;
  const std::vector<Index> vertexOfPass = placesByLabel(passes.labels());
  surfaces.mesh.points.resize(vertexOfPass.size());
  forEachIndex(execution, static_cast<std::int64_t>(vertexOfPass.size()),
    [&](Index pass) {
      surfaces.mesh.points[at(vertexOfPass[at(pass)])] = points[at(passes.vertices()[at(pass)])];
    });
  const std::vector<Index> sides = sidesByLabel(net, triangles);
  surfaces.mesh.cornerVertices.resize(3 * sides.size());
  surfaces.mesh.faceOffsets.resize(sides.size() + 1);
  surfaces.triangles.resize(sides.size());
  surfaces.labels.resize(sides.size());
  surfaces.others.resize(sides.size());
  forEachIndex(execution, static_cast<std::int64_t>(sides.size()),
    [&](Index face)
    {
      const Index triangle = sides[at(face)] / 2;
      const Index side = sides[at(face)] % 2;
      const NetQuad& quad = net.quads[at(triangles.quads[at(triangle)])];
      for (Index k = 0; k < 3; ++k)
      {
        // The second side sees the triangle from behind.
        const Index corner = 3 * triangle + (side == 0 ? k : 2 - k);
        surfaces.mesh.cornerVertices[at(3 * face + k)] =
          vertexOfPass[at(passes.pass(corner, side))];
      }
      surfaces.mesh.faceOffsets[at(face) + 1] = 3 * (face + 1);
      surfaces.triangles[at(face)] = triangle;
      surfaces.labels[at(face)] = quad.sides[at(side)];
      surfaces.others[at(face)] = quad.sides[at(1 - side)];
    });
  return surfaces;
}

} // namespace

ClosedSurfaces closedSurfaces(const InterfaceNet& net, InterfaceTriangles& triangles,
  std::vector<Vec3>& points, const Execution& execution)
{
  const auto first = static_cast<Index>(points.size());
  {
    const SurfacePasses passes(net, triangles, first, execution.phase(0.0, 0.5));
    const std::vector<NetEdge> ambiguous = passes.ambiguousEdges(execution);
    if (ambiguous.empty())
    {
      return surfacesOf(net, triangles, points, passes, execution);
    }
    for (const NetEdge& edge : ambiguous)
    {
      points.emplace_back(0.5 * (points[at(edge[0])] + points[at(edge[1])]));
    }
    splitEdges(ambiguous, first, triangles);
  }
  const auto vertexCount = static_cast<Index>(points.size());
  const SurfacePasses passes(net, triangles, vertexCount, execution.phase(0.5, 1.0));
  return surfacesOf(net, triangles, points, passes, execution);
}

} // namespace evolving
