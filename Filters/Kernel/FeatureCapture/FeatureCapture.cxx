// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/FeatureCapture.h"

#include "FeatureCapture/BorderReach.h"
#include "FeatureCapture/CornerEdges.h"
#include "FeatureCapture/FaceLabels.h"
#include "FeatureCapture/FeatureReference.h"
#include "FeatureCapture/LabelIslands.h"
#include "FeatureCapture/LabelSplitting.h"
#include "FeatureCapture/VertexLabels.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

/// In sizes: both ends of an edge on a crease are as near to it, but for rounding.
constexpr double OnCrease = 1e-6;

/// Turns labels of faces into patches and curves.
class Capture
{
public:
  Capture(EditableSurface& surface, const TargetFeatures& features, VertexLabels& labels)
    : Surface(surface)
    , Features(features)
    , Vertices(labels)
    , Reach(surface, features)
  {
  }

  void run()
  {
    this->placeOnBorders();
    this->markCreases();
    this->namePatches();
    this->pinCorners();
  }

private:
  Index labelBeside(Index e) const { return this->Surface.label(EditableSurface::faceOf(e)); }
  Index labelBeyond(Index e) const
  {
    const Index o = this->Surface.opposite(e);
    return this->labelBeside(o == NoIndex ? e : o);
  }

  Labels labelsAround(Index v) const
  {
    std::vector<Index> labels;
    this->Surface.forEachOutgoing(v, [&](Index e) { labels.push_back(this->labelBeside(e)); });
    return labelSet(std::move(labels));
  }

  /// Vertices between faces of two labels, or of more, go where those meet.
  void placeOnBorders()
  {
    for (Index v = 0; v < this->Surface.vertexSlots(); ++v)
    {
      if (!this->Vertices.mayMove(this->Surface, v))
      {
        continue;
      }
      const Labels around = this->labelsAround(v);
      if (around.size() == 2)
      {
        this->Surface.setPoint(v,
          this->Reach.onBorder(
            this->Surface.point(v), around[0], around[1], this->Surface.size(v)));
      }
      else if (around.size() > 2)
      {
        this->placeOnMeeting(v, around);
      }
    }
  }

  void placeOnMeeting(Index v, const Labels& around)
  {
    const Index meeting = this->Features.borders().closestMeeting(this->Surface.point(v), around);
    if (meeting == NoIndex)
    {
      return;
    }
    const Vec3& place = this->Features.target().point(meeting);
    if ((place - this->Surface.point(v)).norm() >
      this->Reach.ofCorner(meeting, this->Surface.size(v)))
    {
      return;
    }
    Index toTaker = NoIndex;
    this->Surface.forEachOutgoing(v,
      [&](Index e)
      { toTaker = this->Vertices.corner(this->Surface.to(e)) == meeting ? e : toTaker; });
    if (toTaker != NoIndex)
    {
      if (this->Surface.canCollapse(toTaker))
      {
        this->Surface.collapse(toTaker);
      }
    }
    else if (!this->Vertices.isTaken(meeting))
    {
      this->Surface.setPoint(v, place);
      this->Vertices.setCorner(v, meeting);
    }
  }

  void markCreases()
  {
    for (Index e = 0; e < this->Surface.edgeSlots(); ++e)
    {
      if (this->Surface.hasEdge(e) && this->Surface.isFirstHalf(e) &&
        this->labelBeside(e) != this->labelBeyond(e))
      {
        this->Surface.setCurve(e, this->curveAt(e));
      }
    }
  }

  /// The curve between the labels of an edge's faces that both its ends lie on; or NoIndex.
  Index curveAt(Index e) const
  {
    const Index a = this->labelBeside(e);
    const Index b = this->labelBeyond(e);
    const Vec3& from = this->Surface.point(this->Surface.from(e));
    const Vec3& to = this->Surface.point(this->Surface.to(e));
    const LabelBorders& borders = this->Features.borders();
    const Vec3 middle = 0.5 * (from + to);
    const EdgePoint sharp = borders.closest(middle, a, b, EdgeKind::Sharp);
    const EdgePoint artificial = borders.closest(middle, a, b, EdgeKind::Artificial);
    if (!sharp.exists() || artificial.squaredDistance < sharp.squaredDistance)
    {
      return NoIndex;
    }
    const double tolerance = OnCrease * this->Surface.size(this->Surface.from(e));
    const auto isOn = [&](const Vec3& p)
    { return borders.closest(p, a, b, EdgeKind::Sharp).squaredDistance <= tolerance * tolerance; };
    return isOn(from) && isOn(to) ? this->Features.curves().curveOf(sharp.edge) : NoIndex;
  }

  /// Labels become patches; between two patches without a crease faces belong to neither.
  void namePatches()
  {
    std::vector<Index> patchOfLabel(at(this->Features.labelCount()), FeatureReference::NoPatch);
    for (Index t = 0; t < this->Features.target().mesh().faceCount(); ++t)
    {
      const Index patch = this->Features.patchOf(t);
      patchOfLabel[at(this->Features.labelOf(t))] =
        this->Features.isExcludedPatch(patch) ? FeatureReference::NoPatch : patch;
    }
    for (Index f = 0; f < this->Surface.faceSlots(); ++f)
    {
      this->Surface.setLabel(f, patchOfLabel[at(this->Surface.label(f))]);
    }
    std::vector<Index> open;
    for (Index e = 0; e < this->Surface.edgeSlots(); ++e)
    {
      if (this->Surface.hasEdge(e) && !this->Surface.isFeature(e) &&
        this->labelBeside(e) != this->labelBeyond(e))
      {
        open.push_back(EditableSurface::faceOf(e));
      }
    }
    for (const Index face : open)
    {
      this->Surface.setLabel(face, FeatureReference::NoPatch);
    }
  }

  /// Where labels meet without a tip or a corner of the creases, vertices stay free.
  void pinCorners()
  {
    for (Index v = 0; v < this->Surface.vertexSlots(); ++v)
    {
      const Index corner = this->Vertices.corner(v);
      if (this->Surface.hasVertex(v) && corner != NoIndex &&
        (this->Features.isTip(corner) ||
          (this->Features.curves().isCorner(corner) && this->Surface.featureEdges(v) > 0)))
      {
        this->Surface.setPinned(v);
      }
    }
  }

  EditableSurface& Surface;
  const TargetFeatures& Features;
  VertexLabels& Vertices;
  BorderReach Reach;
};

} // namespace

void captureFeatures(
  EditableSurface& surface, const TargetFeatures& features, const Execution& execution)
{
  execution.report(0.0);
  VertexLabels labels(surface, features, execution);
  execution.report(0.25);
  splitLabelChanges(surface, features, labels);
  execution.report(0.5);
  joinCorners(surface, features, labels);
  labelFaces(surface, features, labels);
  joinIslands(surface);
  execution.report(0.75);
  Capture(surface, features, labels).run();
}

} // namespace evolving
