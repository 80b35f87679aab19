// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Where labels meet: the curves between two, and the points between three or more.
 */

#ifndef EVOLVING_LABEL_BORDERS_H
#define EVOLVING_LABEL_BORDERS_H

#include "Features/PolylineTree.h"
#include "Features/SharpEdges.h"
#include "Features/SurfacePatches.h"
#include "Features/TargetTriangles.h"
#include "Types.h"

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace evolving
{

/// What an edge of the target is.
enum class EdgeKind : char
{
  Inner,     ///< inside a label, or the boundary of the surface
  Sharp,     ///< a crease that is kept
  Artificial ///< between two labels, but no crease
};

/// The edges between every two labels, and the vertices where three or more meet.
class LabelBorders
{
public:
  struct Meeting
  {
    Index vertex;
    std::vector<Index> labels; ///< ascending
  };

  LabelBorders(
    const TargetTriangles& target, const SharpEdges& sharp, const TriangleLabels& labels);

  EdgeKind kind(Index edge) const { return this->Kinds[static_cast<std::size_t>(edge)]; }
  double length(EdgeKind kind) const { return this->Lengths[static_cast<std::size_t>(kind)]; }

  /// The point closest to a given one on the border of labels a and b; of both kinds the nearer.
  EdgePoint closest(const Vec3& point, Index a, Index b) const;
  /// On the part of the border that is sharp, or artificial.
  EdgePoint closest(const Vec3& point, Index a, Index b, EdgeKind kind) const;

  /// By vertex.
  const std::vector<Meeting>& meetings() const { return this->Meetings; }
  /**
   * The vertex nearest to a point where (at least) some labels meet; NoIndex when there is none.
   * @param labels three or more, ascending
   */
  Index closestMeeting(const Vec3& point, const std::vector<Index>& labels) const;

private:
  using Trees = std::array<std::unique_ptr<PolylineTree>, 2>; ///< sharp, artificial

  void classifyEdges(
    const TargetTriangles& target, const SharpEdges& sharp, const TriangleLabels& labels);
  void findMeetings(const TargetTriangles& target, const TriangleLabels& labels);

  std::vector<EdgeKind> Kinds;
  std::array<double, 3> Lengths{};
  std::map<std::pair<Index, Index>, Trees> Borders; ///< by smaller and larger label
  std::vector<Meeting> Meetings;
  std::vector<Vec3> MeetingPoints;
  std::vector<std::vector<Index>> MeetingsOfLabel;
};

} // namespace evolving

#endif
