// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Capturing of what is special: too narrow, smooth, large, cancelled.

#include "Errors.h"
#include "FeatureCapture/CaptureMeasures.h"
#include "FeatureCapture/CaptureShapes.h"
#include "FeatureCapture/FeatureCoverage.h"
#include "Mesh/SelfIntersections.h"
#include "ParallelLoops.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/Spheres.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

namespace
{

using namespace evolving;
using namespace evolving::capture;

TEST(FeatureCaptureOf, AChamferTooNarrowForElementsIsOneCrease)
{
  // Of its two long edges one is left out, and with it the strip. Edges of the
  // result may cut across the corner that is left of it.
  const Shape shape{ "Chamfer", shapes::chamferedCube(0.03), 30.0, 0.12 };
  const TargetFeatures features = featuresOf(shape);
  EXPECT_GT(features.leftOut().length, 0.99);
  const EditableSurface surface = captured(shape, features);
  const FeatureCoverage coverage = featureCoverage(surface, features, 0.01, 0.03);
  EXPECT_EQ(coverage.missing, 0.0) << coverage.place.transpose();
  EXPECT_LT(farthestFromCreases(surface, features, false), Rounding);
  EXPECT_EQ(selfIntersections(surface.mesh()).size(), 0u);
}

TEST(FeatureCaptureOf, ASmoothSurfaceChangesNothing)
{
  const SurfaceMesh target = shapes::sphere(4);
  const TargetFeatures features = findFeatures(target, {});
  EditableSurface surface = landed(target, 0.2);
  const SurfaceMesh before = surface.mesh();
  captureFeatures(surface, features);
  EXPECT_TRUE(surface.mesh() == before);
  EXPECT_EQ(captureLength(surface), 0.0);
  EXPECT_EQ(countPins(surface), 0);
}

TEST(FeatureCaptureOf, ACornerWithoutACreaseNeedsNoPin)
{
  // The ridge of a cone is its rim; its apex is none of FeatureCurves' corners.
  const Shape shape = creasedShapes()[4];
  const TargetFeatures features = featuresOf(shape);
  EXPECT_EQ(features.patchCount(), 2);
  EXPECT_EQ(countPins(captured(shape, features)), 0);
}

TEST(FeatureCaptureOf, AnythingHasTheSameBitsOnAnyThreads)
{
  // More vertices than one thread takes at once.
  Shape shape = creasedShapes()[5];
  shape.size = 0.06;
  const TargetFeatures features = featuresOf(shape);
  const EditableSurface before = landed(shape.target, shape.size);
  ASSERT_GT(before.vertexSlots(), LoopGrain);
  EditableSurface serial = before;
  captureFeatures(serial, features);
  for (const int threads : { 1, 4 })
  {
    EditableSurface other = before;
    captureFeatures(other, features, threadedExecution(threads, 7u));
    EXPECT_TRUE(other.mesh() == serial.mesh());
    for (const Index e : editing::edgesOf(other))
    {
      ASSERT_EQ(other.curve(e), serial.curve(e));
      ASSERT_EQ(other.label(e / 3), serial.label(e / 3));
    }
  }
}

TEST(FeatureCaptureOf, AnythingCanBeCancelled)
{
  const Shape shape = creasedShapes()[0];
  const TargetFeatures features = featuresOf(shape);
  EditableSurface surface = landed(shape.target, shape.size);
  const Execution cancelled(nullptr, nullptr, [] { return true; });
  EXPECT_THROW(captureFeatures(surface, features, cancelled), Cancelled);
}

} // namespace
