// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/LabelBorders.h"

#include <algorithm>
#include <limits>

namespace evolving
{

namespace
{

std::size_t treeOf(EdgeKind kind)
{
  return kind == EdgeKind::Sharp ? 0 : 1;
}

/// The different labels of some triangles, ascending.
template <typename Iterator, typename FaceOf>
std::vector<Index> labelsOf(
  const TriangleLabels& labels, Iterator first, Iterator last, const FaceOf& faceOf)
{
  std::vector<Index> found;
  for (; first != last; ++first)
  {
    found.push_back(labels[faceOf(*first)]);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

} // namespace

LabelBorders::LabelBorders(
  const TargetTriangles& target, const SharpEdges& sharp, const TriangleLabels& labels)
  : MeetingsOfLabel(at(labels.count))
{
  this->classifyEdges(target, sharp, labels);
  this->findMeetings(target, labels);
}

void LabelBorders::classifyEdges(
  const TargetTriangles& target, const SharpEdges& sharp, const TriangleLabels& labels)
{
  std::map<std::pair<Index, Index>, std::array<std::vector<Index>, 2>> edgesOfBorder;
  for (Index edge = 0; edge < target.edges().edgeCount(); ++edge)
  {
    const std::vector<Index> beside = labelsOf(
      labels, target.edges().begin(edge), target.edges().end(edge), TargetTriangles::faceOf);
    const EdgeKind smooth = beside.size() > 1 ? EdgeKind::Artificial : EdgeKind::Inner;
    this->Kinds.push_back(sharp.isSharp(edge) ? EdgeKind::Sharp : smooth);
    this->Lengths[static_cast<std::size_t>(this->Kinds.back())] += target.edgeLength(edge);
    for (std::size_t a = 0; a < beside.size(); ++a)
    {
      for (std::size_t b = a + 1; b < beside.size(); ++b)
      {
        edgesOfBorder[{ beside[a], beside[b] }][treeOf(this->Kinds.back())].push_back(edge);
      }
    }
  }
  for (auto& [pair, edges] : edgesOfBorder)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      this->Borders[pair][k] = std::make_unique<PolylineTree>(target, std::move(edges[k]));
    }
  }
}

void LabelBorders::findMeetings(const TargetTriangles& target, const TriangleLabels& labels)
{
  for (Index vertex = 0; vertex < target.mesh().vertexCount(); ++vertex)
  {
    std::vector<Index> around = labelsOf(
      labels, target.facesBegin(vertex), target.facesEnd(vertex), [](Index face) { return face; });
    if (around.size() >= 3)
    {
      for (const Index label : around)
      {
        this->MeetingsOfLabel[at(label)].push_back(static_cast<Index>(this->Meetings.size()));
      }
      this->MeetingPoints.push_back(target.point(vertex));
      this->Meetings.push_back({ vertex, std::move(around) });
    }
  }
}

EdgePoint LabelBorders::closest(const Vec3& point, Index a, Index b) const
{
  const EdgePoint sharp = this->closest(point, a, b, EdgeKind::Sharp);
  const EdgePoint artificial = this->closest(point, a, b, EdgeKind::Artificial);
  return sharp.squaredDistance <= artificial.squaredDistance ? sharp : artificial;
}

EdgePoint LabelBorders::closest(const Vec3& point, Index a, Index b, EdgeKind kind) const
{
  const auto found = this->Borders.find(std::minmax(a, b));
  return found == this->Borders.end() || kind == EdgeKind::Inner
    ? EdgePoint{}
    : found->second[treeOf(kind)]->closest(point);
}

Index LabelBorders::closestMeeting(const Vec3& point, const std::vector<Index>& labels) const
{
  Index best = NoIndex;
  double bestSquared = std::numeric_limits<double>::infinity();
  for (const Index m : this->MeetingsOfLabel[at(labels.front())])
  {
    const std::vector<Index>& around = this->Meetings[at(m)].labels;
    const double squared = (this->MeetingPoints[at(m)] - point).squaredNorm();
    if (squared < bestSquared &&
      std::includes(around.begin(), around.end(), labels.begin(), labels.end()))
    {
      bestSquared = squared;
      best = this->Meetings[at(m)].vertex;
    }
  }
  return best;
}

} // namespace evolving
