// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/FeatureReference.h"

#include "ParallelLoops.h"

namespace evolving
{

FeatureReference::FeatureReference(const ReferenceSurface& others, const TargetFeatures& features,
  double reach, const Execution& execution)
  : Others(others)
  , SquaredReach(reach * reach)
{
  const SurfaceMesh& triangles = features.target().mesh();
  std::vector<SurfaceMesh> patches(at(features.patchCount()));
  for (Index f = 0; f < triangles.faceCount(); ++f)
  {
    SurfaceMesh& patch = patches[at(features.patchOf(f))];
    const Index first = patch.vertexCount();
    for (Index k = 0; k < 3; ++k)
    {
      patch.addPoint(triangles.facePoint(f, k));
    }
    patch.addFace({ first, first + 1, first + 2 });
  }
  for (const SurfaceMesh& patch : patches)
  {
    this->Patches.emplace_back(patch, execution.phase(0.0, 0.0));
  }
  for (const FeatureCurve& curve : features.curves().curves())
  {
    this->Curves.emplace_back(features.target(), curve.edges);
  }
}

ReferenceSurface::Foot FeatureReference::onSurface(
  const Vec3& point, const Vec3& facing, Index label, Index guess) const
{
  if (label == NoPatch)
  {
    return this->Others.onSurface(point, facing, label, guess);
  }
  const AABBTree& patch = this->Patches[at(label)];
  const ClosestTriangle closest = patch.closest(point, this->SquaredReach, guess);
  if (closest.triangle == NoIndex)
  {
    return { point, facing, guess };
  }
  const Vec3 normal = patch.triangle(closest.triangle).doubleAreaNormal().stableNormalized();
  return { closest.at.point, normal.dot(facing) < 0.0 ? Vec3(-normal) : normal, closest.triangle };
}

Vec3 FeatureReference::onCurve(const Vec3& point, Index curve) const
{
  return this->Curves[at(curve)].closest(point).point;
}

} // namespace evolving
