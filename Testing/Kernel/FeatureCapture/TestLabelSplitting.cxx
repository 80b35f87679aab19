// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// What captureFeatures() is made of: labels of vertices, splits, labels of faces.

#include "FeatureCapture/LabelSplitting.h"

#include "FeatureCapture/CaptureShapes.h"
#include "FeatureCapture/FaceLabels.h"
#include "FeatureCapture/LabelSets.h"
#include "FeatureCapture/VertexLabels.h"
#include "Remeshing/EdgeLengthLimits.h"
#include "Remeshing/EditingChecks.h"
#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace evolving;
using namespace evolving::capture;

TEST(LabelSets, AreSets)
{
  EXPECT_EQ(labelSet({ 5, 1, 5, 3, 1 }), (Labels{ 1, 3, 5 }));
  EXPECT_EQ(inBoth({ 1, 3, 5 }, { 2, 3, 4, 5 }), (Labels{ 3, 5 }));
  EXPECT_EQ(inEither({ 1, 3 }, { 2, 3 }), (Labels{ 1, 2, 3 }));
  EXPECT_TRUE(inBoth({ 1, 3 }, { 2 }).empty());
  EXPECT_TRUE(contains({ 1, 3 }, 3));
  EXPECT_FALSE(contains({ 1, 3 }, 2));
}

class CaptureStep : public testing::TestWithParam<Shape>
{
protected:
  CaptureStep()
    : Features(featuresOf(GetParam()))
    , Before(landed(GetParam().target, GetParam().size))
    , Surface(Before)
  {
  }
  TargetFeatures Features;
  EditableSurface Before;
  EditableSurface Surface;
};

/// The labels of the target's triangles at a point, to rounding.
Labels labelsAt(const TargetFeatures& features, const Vec3& point)
{
  std::vector<Index> labels;
  for (Index label = 0; label < features.labelCount(); ++label)
  {
    if (features.closestPointWithLabel(point, label, 1e-20).triangle != NoIndex)
    {
      labels.push_back(label);
    }
  }
  return labels;
}

TEST_P(CaptureStep, VertexLabelsAreThoseOfThePlaceWhereAVertexLies)
{
  const VertexLabels labels(this->Surface, this->Features, {});
  for (const Index v : editing::verticesOf(this->Surface))
  {
    // Vertices across a crease are off the target: the closest label.
    const Labels at = labelsAt(this->Features, this->Surface.point(v));
    if (labels.of(v).size() > 1)
    {
      ASSERT_EQ(labels.of(v), at);
    }
    else if (!at.empty())
    {
      ASSERT_TRUE(contains(at, labels.of(v).front()));
    }
    const double moved = (this->Surface.point(v) - this->Before.point(v)).norm();
    // Onto a border it goes less far than a neighbour is, and onto a corner that is next to it.
    const double most = labels.corner(v) == NoIndex ? ShortestPerSize : LongestPerSize;
    ASSERT_LT(moved, most * GetParam().size);
    ASSERT_TRUE(moved == 0.0 || labels.of(v).size() > 1 || labels.corner(v) != NoIndex);
  }
}

TEST_P(CaptureStep, VertexLabelsGiveEachCornerTheNearestVertex)
{
  const VertexLabels labels(this->Surface, this->Features, {});
  std::vector<Index> taken;
  for (const Index v : editing::verticesOf(this->Surface))
  {
    if (labels.corner(v) != NoIndex)
    {
      taken.push_back(labels.corner(v));
      EXPECT_EQ(this->Surface.point(v), this->Features.target().point(labels.corner(v)));
      EXPECT_FALSE(labels.mayMove(this->Surface, v));
    }
  }
  std::sort(taken.begin(), taken.end());
  EXPECT_EQ(std::unique(taken.begin(), taken.end()), taken.end());
  for (const Index corner : this->Features.curves().corners())
  {
    const Vec3& place = this->Features.target().point(corner);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Index v : editing::verticesOf(this->Before))
    {
      nearest = std::min(nearest, (this->Before.point(v) - place).norm());
    }
    const bool isTaken = std::binary_search(taken.begin(), taken.end(), corner);
    // No place of a triangle is farther from all its vertices.
    const double inside = LongestPerSize / std::sqrt(3.0) * GetParam().size;
    EXPECT_TRUE(isTaken || nearest > inside) << place.transpose();
    EXPECT_TRUE(!isTaken || nearest < LongestPerSize * GetParam().size) << place.transpose();
  }
}

/// The distance of a point from the nearest border between two of some labels.
double distanceToBorder(const TargetFeatures& features, const Vec3& point, const Labels& labels)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Index a : labels)
  {
    for (const Index b : labels)
    {
      const EdgePoint closest = features.borders().closest(point, a, b);
      least = closest.exists() ? std::min(least, closest.squaredDistance) : least;
    }
  }
  return std::sqrt(least);
}

TEST_P(CaptureStep, SplittingLeavesNoEdgeBetweenTwoLabels)
{
  VertexLabels labels(this->Surface, this->Features, {});
  const EditableSurface snapped = this->Surface;
  splitLabelChanges(this->Surface, this->Features, labels);
  editing::expectConsistent(this->Surface);
  Index apart = 0;
  for (const Index e : editing::edgesOf(this->Surface))
  {
    const Labels common = inBoth(labels.of(this->Surface.from(e)), labels.of(this->Surface.to(e)));
    apart += common.empty() ? 1 : 0;
  }
  EXPECT_EQ(apart, 0);
  EXPECT_GT(this->Surface.vertexSlots(), snapped.vertexSlots());
  for (Index v = 0; v < this->Surface.vertexSlots(); ++v)
  {
    if (v < snapped.vertexSlots())
    {
      ASSERT_EQ(this->Surface.point(v), snapped.point(v));
    }
    else
    {
      ASSERT_GE(labels.of(v).size(), 2u);
      const double off = distanceToBorder(this->Features, this->Surface.point(v), labels.of(v));
      ASSERT_TRUE(off < 1e-12 || off > 0.5 * GetParam().size) << off;
    }
  }
}

TEST_P(CaptureStep, FacesGetALabelOfTheirCorners)
{
  VertexLabels labels(this->Surface, this->Features, {});
  splitLabelChanges(this->Surface, this->Features, labels);
  labelFaces(this->Surface, this->Features, labels);
  Index shared = 0;
  for (const Index f : editing::facesOf(this->Surface))
  {
    int corners = 0;
    for (Index k = 0; k < 3; ++k)
    {
      const Labels& ofCorner = labels.of(this->Surface.from(3 * f + k));
      corners += contains(ofCorner, this->Surface.label(f)) ? 1 : 0;
    }
    ASSERT_GE(corners, 1);
    shared += corners == 3 ? 1 : 0;
  }
  EXPECT_GE(shared, static_cast<Index>(editing::facesOf(this->Surface).size()) - 4);
}

INSTANTIATE_TEST_SUITE_P(On, CaptureStep, testing::ValuesIn(creasedShapes()),
  [](const testing::TestParamInfo<Shape>& shape) { return shape.param.name; });

} // namespace
