// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/VertexLabels.h"

#include "ParallelLoops.h"
#include "Remeshing/FaceShape.h"

#include <limits>
#include <tuple>

namespace evolving
{

namespace
{

/// In sizes: how far a vertex moves onto a border. Cut beside a vertex that is nearer, an
/// equilateral triangle would keep a piece with an angle below 17 degrees.
constexpr double SnapSizes = 0.3;
/// In sizes: how far a vertex moves onto a corner. The vertices of a triangle with the longest
/// edges that there are, LongestPerSize, are 0.77 from its middle.
constexpr double CornerSizes = 1.0;
/// Of the faces around a vertex that moves onto a border: faceShape() of a needle of 7 degrees, and
/// what a face may turn by that leaves a right crease, with some to spare, 72 degrees.
constexpr double LeastShape = 0.2;
constexpr double LeastCosine = 0.3;

std::vector<Index> borderEdges(const TargetFeatures& features)
{
  std::vector<Index> edges;
  for (Index e = 0; e < features.target().edges().edgeCount(); ++e)
  {
    if (features.borders().kind(e) != EdgeKind::Inner)
    {
      edges.push_back(e);
    }
  }
  return edges;
}

Labels labelsBeside(const TargetFeatures& features, Index edge)
{
  const TriangleEdges& edges = features.target().edges();
  std::vector<Index> labels;
  for (const Index* c = edges.begin(edge); c != edges.end(edge); ++c)
  {
    labels.push_back(features.labelOf(TargetTriangles::faceOf(*c)));
  }
  return labelSet(std::move(labels));
}

Labels labelsAt(const TargetFeatures& features, Index targetVertex)
{
  const TargetTriangles& target = features.target();
  std::vector<Index> labels;
  for (const Index* f = target.facesBegin(targetVertex); f != target.facesEnd(targetVertex); ++f)
  {
    labels.push_back(features.labelOf(*f));
  }
  return labelSet(std::move(labels));
}

/// The corners of the creases, tips, and the vertices where labels meet.
Labels cornersOf(const TargetFeatures& features)
{
  std::vector<Index> vertices = features.curves().corners();
  vertices.insert(vertices.end(), features.tips().begin(), features.tips().end());
  for (const LabelBorders::Meeting& meeting : features.borders().meetings())
  {
    vertices.push_back(meeting.vertex);
  }
  return labelSet(std::move(vertices));
}

/// Would the faces around a vertex neither turn nor degenerate if it were elsewhere?
bool keepsFaces(const EditableSurface& surface, Index v, const Vec3& point)
{
  bool keeps = true;
  surface.forEachOutgoing(v,
    [&](Index e)
    {
      const Vec3& b = surface.point(surface.to(e));
      const Vec3& c = surface.point(surface.apex(e));
      const Vec3 before = surface.doubleArea(EditableSurface::faceOf(e));
      const Vec3 after = (b - point).cross(c - point);
      keeps = keeps && faceShape(point, b, c) >= LeastShape &&
        after.dot(before) >= LeastCosine * after.norm() * before.norm();
    });
  return keeps;
}

} // namespace

VertexLabels::VertexLabels(
  EditableSurface& surface, const TargetFeatures& features, const Execution& execution)
  : Sets(at(surface.vertexSlots()))
  , Corners(at(surface.vertexSlots()), NoIndex)
{
  forEachIndex(execution, surface.vertexSlots(),
    [&](Index v)
    {
      if (surface.hasVertex(v))
      {
        this->Sets[at(v)] = { features.closestPoint(surface.point(v)).label };
      }
    });
  this->takeCorners(surface, features);
  this->snapToBorders(surface, features);
}

void VertexLabels::add(Index v, Index label)
{
  this->Sets[at(v)] = inEither(this->Sets[at(v)], { label });
}

void VertexLabels::append(const Labels& labels)
{
  this->Sets.push_back(labels);
  this->Corners.push_back(NoIndex);
}

bool VertexLabels::mayMove(const EditableSurface& surface, Index v) const
{
  return surface.hasVertex(v) && !surface.isPinned(v) && this->corner(v) == NoIndex;
}

/// Each corner gets the vertex closest to it of those that have none closer; a held one that lies
/// there already, or else a second one would come to lie on it.
void VertexLabels::takeCorners(EditableSurface& surface, const TargetFeatures& features)
{
  const std::vector<Index> corners = cornersOf(features);
  SurfaceMesh points;
  for (const Index corner : corners)
  {
    const Index p = points.addPoint(features.target().point(corner));
    points.addFace({ p, p, p });
  }
  const AABBTree tree(points);
  const std::pair<double, Index> none(std::numeric_limits<double>::infinity(), NoIndex);
  std::vector<std::pair<double, Index>> nearest(corners.size(), none);
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v))
    {
      const double reach = surface.isPinned(v) ? 0.0 : CornerSizes * surface.size(v);
      const ClosestTriangle closest = tree.closest(surface.point(v), reach * reach);
      if (closest.triangle != NoIndex)
      {
        auto& best = nearest[at(closest.triangle)];
        best = std::min(best, std::pair<double, Index>(closest.at.squaredDistance, v));
      }
    }
  }
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    const Index v = nearest[c].second;
    if (v != NoIndex)
    {
      surface.setPoint(v, features.target().point(corners[c]));
      this->Sets[at(v)] = labelsAt(features, corners[c]);
      this->setCorner(v, corners[c]);
    }
  }
}

/// The nearest first, as long as no face around degenerates.
void VertexLabels::snapToBorders(EditableSurface& surface, const TargetFeatures& features)
{
  const PolylineTree borders(features.target(), borderEdges(features));
  std::vector<std::pair<Index, EdgePoint>> near;
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (this->mayMove(surface, v))
    {
      const double reach = SnapSizes * surface.size(v);
      const EdgePoint closest = borders.closest(surface.point(v));
      if (closest.squaredDistance <= reach * reach)
      {
        near.emplace_back(v, closest);
      }
    }
  }
  std::stable_sort(near.begin(), near.end(),
    [](const auto& a, const auto& b)
    { return a.second.squaredDistance < b.second.squaredDistance; });
  for (const auto& [v, closest] : near)
  {
    if (keepsFaces(surface, v, closest.point))
    {
      surface.setPoint(v, closest.point);
      this->Sets[at(v)] = labelsBeside(features, closest.edge);
    }
  }
}

} // namespace evolving
