// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/FeatureCoverage.h"

#include "Trees/AABBTree.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// The edges on creases, each a triangle with two equal corners.
SurfaceMesh creaseEdges(const EditableSurface& surface)
{
  SurfaceMesh edges;
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    if (surface.hasEdge(e) && surface.isFirstHalf(e) && surface.curve(e) != NoIndex)
    {
      const Index a = edges.addPoint(surface.point(surface.from(e)));
      const Index b = edges.addPoint(surface.point(surface.to(e)));
      edges.addFace({ a, b, b });
    }
  }
  return edges;
}

} // namespace

FeatureCoverage featureCoverage(
  const EditableSurface& surface, const TargetFeatures& features, double spacing, double tolerance)
{
  const AABBTree edges(creaseEdges(surface));
  const TargetTriangles& target = features.target();
  FeatureCoverage coverage;
  coverage.length = features.excluded().length;
  coverage.missing = features.excluded().length;
  coverage.place = features.excluded().place;
  coverage.leftOut = features.leftOut();
  for (const FeatureCurve& curve : features.curves().curves())
  {
    for (const Index edge : curve.edges)
    {
      const double length = target.edgeLength(edge);
      const int parts = std::max(1, static_cast<int>(std::ceil(length / spacing)));
      const auto [a, b] = target.edgeVertices(edge);
      for (int i = 0; i < parts; ++i)
      {
        const double t = (i + 0.5) / parts;
        const Vec3 point = (1.0 - t) * target.point(a) + t * target.point(b);
        if (edges.closest(point, tolerance * tolerance).triangle == NoIndex)
        {
          coverage.place = coverage.missing > 0.0 ? coverage.place : point;
          coverage.missing += length / parts;
        }
      }
      coverage.length += length;
    }
  }
  return coverage;
}

} // namespace evolving
