// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/LabelSplitting.h"

#include "FeatureCapture/BorderReach.h"
#include "ParallelLoops.h"

#include <algorithm>
#include <deque>

namespace evolving
{

namespace
{

/// In sizes: the least length of the two edges that a split makes. A nearer end is taken to be on
/// the border itself, far within what counts as on a crease (CrossingSizes).
constexpr double ShortestSizes = 0.02;
/// In sizes: an edge whose ends share a label runs over another one in between where its middle is
/// farther than this from the shared one: nearer creases count as carried (WrapFinish.cxx).
constexpr double CrossingSizes = 0.1;
/// Where four labels meet, splits of what splits have made would go on for ever: an edge stays
/// whole when the generations of its two ends sum to this (0 for vertices that were there before).
/// A face with three labels needs a third one where the second was between its first and a corner.
constexpr int MostSplits = 3;
/// A change of labels is found to this power of 1/2, in lengths of the edge: finer than
/// ShortestSizes by far.
constexpr int Bisections = 12;

/// Where the closest point of the target leaves the labels of an edge's beginning.
struct LabelChange
{
  double place = 1.0; ///< 0 ... 1 along the edge
  Index before = NoIndex;
  Index after = NoIndex;
};

class Splitter
{
public:
  Splitter(EditableSurface& surface, const TargetFeatures& features, VertexLabels& labels)
    : Surface(surface)
    , Features(features)
    , Labels(labels)
    , Reach(surface, features)
    , Splits(at(surface.vertexSlots()), 0)
  {
  }

  void run()
  {
    std::deque<Index> edges;
    for (Index e = 0; e < this->Surface.edgeSlots(); ++e)
    {
      edges.push_back(e);
    }
    while (!edges.empty())
    {
      const Index e = edges.front();
      edges.pop_front();
      const Index m = this->Surface.hasEdge(e) ? this->split(e) : NoIndex;
      if (m != NoIndex)
      {
        // Those around have new numbers.
        this->Surface.forEachOutgoing(m,
          [&edges](Index out) {
            edges.insert(edges.end(), { out, EditableSurface::next(out) });
          });
      }
    }
  }

private:
  /// @return the new vertex; NoIndex when none is needed
  Index split(Index e)
  {
    const Index a = this->Surface.from(e);
    const Index b = this->Surface.to(e);
    const bool isHeld = this->Surface.isPinned(a) && this->Surface.isPinned(b);
    if (isHeld || this->Splits[at(a)] + this->Splits[at(b)] >= MostSplits)
    {
      return NoIndex;
    }
    const evolving::Labels common = inBoth(this->Labels.of(a), this->Labels.of(b));
    if (common.empty())
    {
      return this->splitAt(e, this->changeOn(e, 0.0, 1.0, this->Labels.of(a)));
    }
    const Index between = this->labelAt(this->along(e, 0.5));
    if (contains(common, between) ||
      !this->isAway(this->along(e, 0.5), common, this->Surface.size(a, b)))
    {
      return NoIndex;
    }
    const double end = contains(this->Labels.of(b), between) ? 0.0 : 1.0;
    return this->splitAt(e, this->changeOn(e, 0.5, end, { between }));
  }

  bool isAway(const Vec3& point, const evolving::Labels& labels, double size) const
  {
    const double least = CrossingSizes * size;
    return std::all_of(labels.begin(), labels.end(),
      [&](Index label) {
        return this->Features.closestPointWithLabel(point, label, least * least).triangle ==
          NoIndex;
      });
  }

  /// @return the new vertex; NoIndex when an end turned out to lie on the border itself
  Index splitAt(Index e, const LabelChange& change)
  {
    const double size = this->Surface.size(this->Surface.from(e), this->Surface.to(e));
    const double least = ShortestSizes * size / this->Surface.length(e);
    if (!(change.place > least))
    {
      this->Labels.add(this->Surface.from(e), change.after);
      return NoIndex;
    }
    if (!(change.place < 1.0 - least))
    {
      this->Labels.add(this->Surface.to(e), change.before);
      return NoIndex;
    }
    const Vec3 point =
      this->Reach.onBorder(this->along(e, change.place), change.before, change.after, size);
    const int splits =
      1 + std::max(this->Splits[at(this->Surface.from(e))], this->Splits[at(this->Surface.to(e))]);
    const Index m = this->Surface.split(e, point);
    this->Labels.append(labelSet({ change.before, change.after }));
    this->Splits.push_back(splits);
    return m;
  }

  /// Between two places, the first of which has one of the labels.
  LabelChange changeOn(Index e, double from, double to, const evolving::Labels& near) const
  {
    LabelChange change{ to, near.front(), this->labelAt(this->along(e, to)) };
    if (contains(near, change.after))
    {
      return { to, change.after, change.after };
    }
    double low = from;
    for (int i = 0; i < Bisections; ++i)
    {
      const double middle = 0.5 * (low + change.place);
      const Index label = this->labelAt(this->along(e, middle));
      const bool isBefore = contains(near, label);
      (isBefore ? low : change.place) = middle;
      (isBefore ? change.before : change.after) = label;
    }
    return change;
  }

  Vec3 along(Index e, double t) const
  {
    const Vec3& from = this->Surface.point(this->Surface.from(e));
    return from + t * (this->Surface.point(this->Surface.to(e)) - from);
  }

  Index labelAt(const Vec3& point) const { return this->Features.closestPoint(point).label; }

  EditableSurface& Surface;
  const TargetFeatures& Features;
  VertexLabels& Labels;
  BorderReach Reach;
  std::vector<int> Splits; ///< how many, one after the other, made a vertex
};

} // namespace

void splitLabelChanges(
  EditableSurface& surface, const TargetFeatures& features, VertexLabels& labels)
{
  Splitter(surface, features, labels).run();
}

} // namespace evolving
