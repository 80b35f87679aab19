// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/FaceLabels.h"

#include "ParallelLoops.h"
#include "Trees/TriangleGeometry.h"

#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

/// What speaks for a label of a face, beside the distance in sizes: a triangle that lies as flat,
/// and each neighbour with it. One at a right angle counts as half a size farther away, which three
/// neighbours do not outvote: they decide between labels that are about as good.
constexpr double FlatnessWeight = 0.5;
constexpr double NeighbourWeight = 0.15;
/// A label goes on from face to face by one in a sweep; faces in doubt are no wider strips.
constexpr int Sweeps = 4;

/// What speaks against a label of a face, whatever its neighbours have.
double misfit(
  const EditableSurface& surface, const TargetFeatures& features, Index face, Index label)
{
  const Vec3 centroid =
    (surface.corner(face, 0) + surface.corner(face, 1) + surface.corner(face, 2)) / 3.0;
  const LabelledPoint closest = features.closestPointWithLabel(centroid, label);
  const Vec3 normal =
    triangleOf(features.target().mesh(), closest.triangle).doubleAreaNormal().stableNormalized();
  const double flatness = std::abs(normal.dot(surface.doubleArea(face).stableNormalized()));
  return std::sqrt(closest.squaredDistance) / surface.size(surface.from(3 * face)) +
    FlatnessWeight * (1.0 - flatness);
}

/// A face that may have one of several labels.
struct OpenFace
{
  Index face;
  std::vector<std::pair<Index, double>> misfits; ///< of labels
};

Index bestLabel(const EditableSurface& surface, const OpenFace& open)
{
  Index best = NoIndex;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [label, misfit] : open.misfits)
  {
    double sum = misfit;
    for (Index k = 0; k < 3; ++k)
    {
      const Index o = surface.opposite(3 * open.face + k);
      const bool isLike = o != NoIndex && surface.label(EditableSurface::faceOf(o)) == label;
      sum -= isLike ? NeighbourWeight : 0.0;
    }
    if (best == NoIndex || sum < least)
    {
      least = sum;
      best = label;
    }
  }
  return best;
}

Labels candidates(const EditableSurface& surface, const VertexLabels& labels, Index face)
{
  const Labels& a = labels.of(surface.from(3 * face));
  const Labels& b = labels.of(surface.from(3 * face + 1));
  const Labels& c = labels.of(surface.from(3 * face + 2));
  const Labels common = inBoth(inBoth(a, b), c);
  return common.empty() ? inEither(inEither(a, b), c) : common;
}

} // namespace

void labelFaces(
  EditableSurface& surface, const TargetFeatures& features, const VertexLabels& labels)
{
  std::vector<OpenFace> open;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (!surface.hasFace(f))
    {
      continue;
    }
    const Labels choice = candidates(surface, labels, f);
    surface.setLabel(f, choice.front());
    if (choice.size() > 1)
    {
      open.push_back({ f, {} });
      for (const Index label : choice)
      {
        open.back().misfits.emplace_back(label, misfit(surface, features, f, label));
      }
    }
  }
  for (int sweep = 0; sweep < Sweeps; ++sweep)
  {
    for (const OpenFace& face : open)
    {
      surface.setLabel(face.face, bestLabel(surface, face));
    }
  }
}

} // namespace evolving
