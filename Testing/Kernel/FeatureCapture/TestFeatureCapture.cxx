// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Every crease becomes edges, every corner a vertex, every face belongs to one patch.

#include "FeatureCapture/FeatureCapture.h"

#include "FeatureCapture/CaptureMeasures.h"
#include "FeatureCapture/CaptureShapes.h"
#include "FeatureCapture/FeatureCoverage.h"
#include "FeatureCapture/FeatureReference.h"
#include "Mesh/SelfIntersections.h"
#include "Remeshing/EditingChecks.h"
#include "Shapes/MeshVariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using namespace evolving;

using namespace evolving::shapes;
using namespace evolving::capture;

class FeatureCapture : public testing::TestWithParam<Shape>
{
protected:
  FeatureCapture()
    : Features(featuresOf(GetParam()))
    , Before(landed(GetParam().target, GetParam().size))
    , Surface(Before)
  {
    captureFeatures(this->Surface, this->Features);
  }

  static double size() { return GetParam().size; }
  /// What the creases may lack.
  static double lostTips() { return GetParam().looseEnds * size(); }
  void expectPins(const EditableSurface& surface) const
  {
    const auto corners = static_cast<int>(GetParam().corners);
    EXPECT_LE(countPins(surface), corners);
    EXPECT_GE(countPins(surface), corners - GetParam().looseEnds);
  }

  TargetFeatures Features;
  EditableSurface Before;
  EditableSurface Surface;
};

TEST_P(FeatureCapture, CoversEveryCrease)
{
  ASSERT_EQ(this->Features.curves().curves().size(), GetParam().curves);
  ASSERT_EQ(this->Features.curves().corners().size(), GetParam().corners);
  ASSERT_EQ(this->Features.leftOut().length, 0.0);
  const FeatureCoverage before = featureCoverage(this->Before, this->Features, 0.1 * size(), 0.01);
  EXPECT_NEAR(before.missing, before.length, 1e-9);
  // Of a rim, chords between points on it.
  const double tolerance = GetParam().corners > 0 ? 1e-9 : 0.05 * size();
  const FeatureCoverage coverage =
    featureCoverage(this->Surface, this->Features, 0.1 * size(), tolerance);
  EXPECT_NEAR(coverage.length, GetParam().length, 1e-9);
  EXPECT_LE(coverage.missing, lostTips()) << coverage.place.transpose();
}

TEST_P(FeatureCapture, HasEdgesExactlyOnTheirCreases)
{
  EXPECT_LT(farthestFromCreases(this->Surface, this->Features, false), Rounding);
  const bool isStraight = GetParam().corners > 0;
  const double sagitta = size() * size() / 2.0;
  EXPECT_LT(
    farthestFromCreases(this->Surface, this->Features, true), isStraight ? Rounding : sagitta);
  // Once each, neither forth and back nor with gaps.
  const double chords = isStraight ? 0.0 : sagitta / 6.0 * GetParam().length;
  EXPECT_LE(captureLength(this->Surface), GetParam().length + 1e-9);
  EXPECT_GE(captureLength(this->Surface), GetParam().length - chords - lostTips() - 1e-9);
}

TEST_P(FeatureCapture, PinsAVertexAtEveryCorner)
{
  int without = 0;
  for (const Index corner : this->Features.curves().corners())
  {
    const Vec3& place = this->Features.target().point(corner);
    const int pins = pinsAt(this->Surface, place);
    EXPECT_LE(pins, 1) << place.transpose();
    without += pins == 0 ? 1 : 0;
  }
  EXPECT_LE(without, GetParam().looseEnds);
  this->expectPins(this->Surface);
}

TEST_P(FeatureCapture, KnowsThePatchOfEveryFace)
{
  std::vector<Index> faces(static_cast<std::size_t>(this->Features.patchCount()), 0);
  for (const Index f : editing::facesOf(this->Surface))
  {
    const Index patch = this->Surface.label(f);
    ASSERT_NE(patch, FeatureReference::NoPatch);
    ++faces[static_cast<std::size_t>(patch)];
    const Vec3 middle = centroid(this->Surface, f);
    const double nearest = squaredDistanceToPatch(this->Features, patch, middle);
    const double closest = this->Features.closestPoint(middle).squaredDistance;
    EXPECT_NEAR(std::sqrt(nearest), std::sqrt(closest), 1e-9) << middle.transpose();
  }
  EXPECT_EQ(std::count(faces.begin(), faces.end(), 0), 0);
}

TEST_P(FeatureCapture, PatchesEndAtCreasesOnly)
{
  for (const Index e : editing::edgesOf(this->Surface))
  {
    const Index beyond = EditableSurface::faceOf(this->Surface.opposite(e));
    const bool isBorder =
      this->Surface.label(EditableSurface::faceOf(e)) != this->Surface.label(beyond);
    // On both sides of a crease that ends inside a patch is that patch.
    EXPECT_TRUE(!isBorder || this->Surface.curve(e) != NoIndex);
  }
}

TEST_P(FeatureCapture, KeepsAClosedManifoldThatDoesNotIntersect)
{
  editing::expectConsistent(this->Surface);
  this->Surface.compact();
  const SurfaceMesh mesh = this->Surface.mesh();
  EXPECT_EQ(editing::kindOf(mesh), editing::kindOf(GetParam().target));
  EXPECT_FALSE(editing::hasTwinFaces(mesh));
  EXPECT_EQ(selfIntersections(mesh).size(), 0u);
}

/// Remeshed in between: what is captured stays as it is, and no second vertex comes to a corner.
TEST_P(FeatureCapture, OnceMoreGoesWell)
{
  const OffsetReference target(GetParam().target, 0.0);
  const FeatureReference reference(target, this->Features, 2.0 * size());
  for (int pass = 0; pass < 3; ++pass)
  {
    remeshOnce(this->Surface, reference, {});
  }
  const auto expectCovered = [&]
  {
    const FeatureCoverage coverage =
      featureCoverage(this->Surface, this->Features, 0.1 * size(), 0.05 * size());
    EXPECT_LE(coverage.missing, lostTips()) << coverage.place.transpose();
    EXPECT_LT(farthestFromCreases(this->Surface, this->Features, false), Rounding);
    this->expectPins(this->Surface);
    EXPECT_EQ(selfIntersections(this->Surface.mesh()).size(), 0u);
  };
  expectCovered();
  captureFeatures(this->Surface, this->Features);
  expectCovered();
}

TEST_P(FeatureCapture, LeavesLockedPartsAlone)
{
  const Vec3 middle = boundingBox(GetParam().target).center();
  EditableSurface surface = this->Before;
  for (const Index v : editing::verticesOf(surface))
  {
    if (surface.point(v).x() < middle.x())
    {
      surface.setLocked(v);
    }
  }
  captureFeatures(surface, this->Features);
  editing::expectConsistent(surface);
  for (const Index v : editing::verticesOf(this->Before))
  {
    if (this->Before.point(v).x() < middle.x())
    {
      ASSERT_TRUE(surface.isLocked(v));
      ASSERT_EQ(surface.point(v), this->Before.point(v));
    }
  }
  for (const Index f : editing::facesOf(this->Before))
  {
    const bool isLocked = surface.isLockedFace(f);
    for (Index k = 0; isLocked && k < 3; ++k)
    {
      ASSERT_EQ(surface.from(3 * f + k), this->Before.from(3 * f + k));
    }
  }
  // On the other side the creases are there.
  const FeatureCoverage coverage =
    featureCoverage(surface, this->Features, 0.1 * size(), 0.05 * size());
  EXPECT_GT(coverage.missing, 0.2 * coverage.length);
  EXPECT_LT(coverage.missing, 0.7 * coverage.length);
  EXPECT_LT(coverage.place.x(), middle.x() + 2.0 * size());
}

TEST_P(FeatureCapture, DoesNotDependOnPlaceAndUnit)
{
  std::mt19937 generator(4);
  const Eigen::Matrix3d rotation = randomRotation(generator);
  for (const double scale : { 1e-4, 1e4 })
  {
    Shape other = GetParam();
    other.size *= scale;
    const Vec3 offset = 100.0 * scale * Vec3(3.0, -2.0, 1.0);
    other.target = transformed(mapped(other.target, rotation), scale, offset);
    const TargetFeatures features = featuresOf(other);
    const EditableSurface surface = captured(other, features);
    const FeatureCoverage coverage =
      featureCoverage(surface, features, 0.1 * other.size, 0.05 * other.size);
    EXPECT_NEAR(coverage.length / scale, GetParam().length, 1e-6);
    EXPECT_LE(coverage.missing, lostTips() * scale);
    this->expectPins(surface);
    EXPECT_EQ(selfIntersections(surface.mesh()).size(), 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, FeatureCapture, testing::ValuesIn(creasedShapes()),
  [](const testing::TestParamInfo<Shape>& shape) { return shape.param.name; });

} // namespace
