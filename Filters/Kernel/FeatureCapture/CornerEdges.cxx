// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/CornerEdges.h"

#include "FeatureCapture/LabelSets.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace evolving
{

namespace
{

/// In sizes: a border that ends at a corner is as near to it, but for rounding.
constexpr double AtCorner = 1e-6;

/// The borders at a vertex on a corner, as pairs of labels.
std::vector<Labels> bordersAt(
  const EditableSurface& surface, const TargetFeatures& features, const Labels& labels, Index v)
{
  const double reach = AtCorner * surface.size(v);
  std::vector<Labels> pairs;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    for (std::size_t j = i + 1; j < labels.size(); ++j)
    {
      const EdgePoint border = features.borders().closest(surface.point(v), labels[i], labels[j]);
      if (border.exists() && border.squaredDistance <= reach * reach)
      {
        pairs.push_back({ labels[i], labels[j] });
      }
    }
  }
  return pairs;
}

bool isOn(const VertexLabels& labels, Index v, const Labels& border)
{
  return inBoth(labels.of(v), border).size() == border.size();
}

bool isJoined(
  const EditableSurface& surface, const VertexLabels& labels, Index v, const Labels& border)
{
  bool isJoined = false;
  surface.forEachNeighbour(v, [&](Index u) { isJoined = isJoined || isOn(labels, u, border); });
  return isJoined;
}

/// The edge across from a vertex behind which the nearest vertex on a border is; NoIndex: there is
/// none that may flip.
Index edgeBefore(
  const EditableSurface& surface, const VertexLabels& labels, Index v, const Labels& border)
{
  Index best = NoIndex;
  double least = std::numeric_limits<double>::infinity();
  surface.forEachOutgoing(v,
    [&](Index e)
    {
      const Index across = EditableSurface::next(e);
      if (!surface.canFlip(across))
      {
        return;
      }
      const Index behind = surface.apex(surface.opposite(across));
      const double distance = (surface.point(behind) - surface.point(v)).squaredNorm();
      if (distance < least && isOn(labels, behind, border))
      {
        least = distance;
        best = across;
      }
    });
  return best;
}

/// @return whether an edge has flipped
bool joinBorder(EditableSurface& surface, const VertexLabels& labels, Index v, const Labels& border)
{
  const Index e =
    isJoined(surface, labels, v, border) ? NoIndex : edgeBefore(surface, labels, v, border);
  if (e != NoIndex)
  {
    surface.flip(e);
  }
  return e != NoIndex;
}

void joinCorner(
  EditableSurface& surface, const VertexLabels& labels, Index v, const std::vector<Labels>& borders)
{
  // A flip may bring the next border into reach.
  bool hasFlipped = true;
  for (std::size_t round = 0; hasFlipped && round < borders.size(); ++round)
  {
    hasFlipped = std::any_of(borders.begin(), borders.end(),
      [&](const Labels& border) { return joinBorder(surface, labels, v, border); });
  }
}

} // namespace

void joinCorners(
  EditableSurface& surface, const TargetFeatures& features, const VertexLabels& labels)
{
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v) && labels.corner(v) != NoIndex)
    {
      joinCorner(surface, labels, v, bordersAt(surface, features, labels.of(v), v));
    }
  }
}

} // namespace evolving
