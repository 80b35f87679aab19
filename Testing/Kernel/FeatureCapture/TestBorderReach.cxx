// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/BorderReach.h"

#include "FeatureCapture/CaptureMeasures.h"
#include "FeatureCapture/CaptureShapes.h"
#include "FeatureCapture/FeatureCoverage.h"
#include "Mesh/Angles.h"
#include "Remeshing/EdgeLengthLimits.h"
#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{

using namespace evolving;
using namespace evolving::capture;

constexpr double Length = 2.0;
constexpr double Height = 1.5;

/// The crease at a point of a blade.
Index creaseAt(const TargetFeatures& features, const Vec3& point)
{
  return features.closestOnCurves(point).edge;
}

/// A surface of a small size but for one vertex, wherever it is.
EditableSurface sized(double small, double large)
{
  EditableSurface surface(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)));
  setUniformSizes(surface, small);
  surface.setSize(0, large);
  return surface;
}

TEST(BorderReach, OfABluntCreaseIsOneAndAHalfSizes)
{
  const TargetFeatures cube = findFeatures(shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)), {});
  const BorderReach reach(sized(0.07, 0.5), cube);
  EXPECT_EQ(reach.ofEdge(creaseAt(cube, Vec3(0.5, 0, 0)), 0.07), 1.5 * 0.07);
  const Index top = cube.closestPoint(Vec3(0.5, 0.5, 2)).label;
  const Index side = cube.closestPoint(Vec3(2, 0.5, 0.5)).label;
  const Vec3 near(0.9, 0.4, 1.0);
  EXPECT_EQ(reach.onBorder(near, top, side, 0.07), Vec3(1.0, 0.4, 1.0));
  EXPECT_EQ(reach.onBorder(near, side, top, 0.07), Vec3(1.0, 0.4, 1.0));
  EXPECT_EQ(reach.onBorder(near, top, side, 0.06), near);
  const Index bottom = cube.closestPoint(Vec3(0.5, 0.5, -1)).label;
  EXPECT_EQ(reach.onBorder(near, top, bottom, 10.0), near);
}

TEST(BorderReach, IsWhereTheLongestEdgeLeadsFromSideToSide)
{
  for (const double degrees : { 8.0, 12.0, 20.0, 40.0 })
  {
    const TargetFeatures features = findFeatures(shapes::blade(degrees, Length, Height), {});
    const BorderReach uniform(sized(0.05, 0.05), features);
    const Index crease = creaseAt(features, Vec3(0.0, 0.0, 0.5 * Height));
    const double reach = uniform.ofEdge(crease, 0.05);
    // Both ends of such an edge are as far from the crease, and LongestPerSize from each other.
    const double half = 0.5 * degrees * RadiansPerDegree;
    EXPECT_NEAR(2.0 * reach * std::sin(half), 0.05 * LongestPerSize, 1e-12) << degrees;
    EXPECT_EQ(uniform.ofCorner(features.closestCorner(Vec3::Zero()), 0.05), reach);
    EXPECT_EQ(uniform.ofCorner(features.closestCorner(Vec3(Length, 0, 0)), 0.05), 1.5 * 0.05);
    // Beside large elements it is larger by what these wear off more.
    const BorderReach varying(sized(0.05, 0.1), features);
    EXPECT_NEAR(varying.ofEdge(crease, 0.05), 2.0 * reach - 1.5 * 0.05, 1e-12);
    const Index below = features.closestPoint(Vec3(1.0, -1.0, 1.0)).label;
    const Index above = features.closestPoint(Vec3(1.0, 1.0, 1.0)).label;
    const Vec3 away(std::cos(half), std::sin(half), 0.0);
    const Vec3 middle(0.0, 0.0, 0.5);
    const Vec3 worn = middle + 0.99 * reach * away;
    const Vec3 farther = middle + 1.01 * reach * away;
    EXPECT_LT((uniform.onBorder(worn, below, above, 0.05) - middle).norm(), 1e-12);
    EXPECT_EQ(uniform.onBorder(farther, below, above, 0.05), farther);
  }
}

TEST(BorderReach, IsBoundedWhereSidesAreNearlyOne)
{
  const TargetFeatures features = findFeatures(shapes::blade(1.0, Length, Height), {});
  const Index crease = creaseAt(features, Vec3(0.0, 0.0, 0.5 * Height));
  EXPECT_NEAR(BorderReach(sized(0.1, 0.1), features).ofEdge(crease, 0.1), 1.2, 1e-12);
}

/// The distance of the surface from the middle half of a blade's edge, the largest.
double wear(const EditableSurface& surface, const Vec3& low, const Vec3& high)
{
  const AABBTree tree(surface.mesh());
  double most = 0.0;
  for (double t = 0.25; t <= 0.75; t += 0.01)
  {
    most = std::max(most, tree.closest(low + t * (high - low)).at.squaredDistance);
  }
  return std::sqrt(most);
}

TEST(BorderReach, BringsBackEdgesOfBladesThatAreWornOff)
{
  std::mt19937 generator(3);
  for (const double degrees : { 8.0, 10.0, 15.0, 25.0 })
  {
    const Eigen::Matrix3d turn = shapes::randomRotation(generator);
    const SurfaceMesh target = shapes::mapped(shapes::blade(degrees, Length, Height), turn);
    const Shape shape{ "Blade", target, 45.0, 0.1 };
    const TargetFeatures features = featuresOf(shape);
    EditableSurface surface = landed(target, shape.size);
    const Vec3 high = turn * Vec3(0, 0, Height);
    EXPECT_GT(wear(surface, Vec3::Zero(), high), 0.1 * shape.size) << degrees;
    captureFeatures(surface, features);
    EXPECT_LT(wear(surface, Vec3::Zero(), high), 1e-12) << degrees;
    EXPECT_LT(farthestFromCreases(surface, features, false), Rounding);
    // All but what is left of the acute corners at its ends.
    EXPECT_LT(featureCoverage(surface, features, 0.01, 0.01).missing, 6.0 * shape.size);
  }
}

} // namespace
