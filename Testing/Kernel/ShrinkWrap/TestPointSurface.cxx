// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ShrinkWrap/PointSurface.h"

#include "Checks/SurfaceMeasures.h"
#include "Errors.h"
#include "Mesh/Angles.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace evolving;

SurfaceMesh pointSet(const std::vector<Vec3>& points)
{
  SurfaceMesh mesh;
  mesh.points = points;
  return mesh;
}

SurfaceMesh amidst(const std::vector<Vec3>& points, const Execution& execution = {})
{
  return surfaceAmidst(pointSet(points), wraps::quick(), execution);
}

std::vector<Vec3> squarePoints(int count)
{
  std::vector<Vec3> points;
  for (int j = 0; j < count; ++j)
  {
    for (int i = 0; i < count; ++i)
    {
      points.emplace_back(2.0 * i / (count - 1) - 1.0, 2.0 * j / (count - 1) - 1.0, 0.0);
    }
  }
  return points;
}

TEST(PointSurface, OfASphereIsNearTheSphere)
{
  const SurfaceMesh surface = amidst(icosphere(4).points);
  wraps::expectSound(surface, 0);
  for (const Vec3& p : surface.points)
  {
    EXPECT_NEAR(p.norm(), 1.0, 0.01);
  }
  EXPECT_NEAR(signedVolume(surface), 4.0 / 3.0 * Pi, 0.04);
}

TEST(PointSurface, OfATorusHasItsHole)
{
  const std::vector<Vec3> points = shapes::torus(60, 24, 1.0, 0.4).points;
  const SurfaceMesh surface = amidst(points);
  wraps::expectSound(surface, 1);
  EXPECT_LT(checks::rmsDistance(points, surface), 0.01);
  EXPECT_NEAR(signedVolume(surface), 2.0 * std::pow(Pi * 0.4, 2.0), 0.1);
}

TEST(PointSurface, OfAPlanarPatchIsAThinWall)
{
  for (const Eigen::Matrix3d& rotation :
    { Eigen::Matrix3d(Eigen::Matrix3d::Identity()), shapes::someRotation() })
  {
    std::vector<Vec3> points = squarePoints(25);
    for (Vec3& p : points)
    {
      p = rotation * p;
    }
    const SurfaceMesh surface = amidst(points);
    wraps::expectSound(surface, 0, 1, 20.0);
    const double spacing = 2.0 / 24.0;
    EXPECT_NEAR(surfaceArea(surface), 2.0 * 4.0, 1.6);
    EXPECT_LT(signedVolume(surface), 4.0 * 2.0 * spacing); // thinner than two points' distance
    double thickest = 0.0;
    for (const Vec3& p : surface.points)
    {
      thickest = std::max(thickest, std::abs((rotation.transpose() * p).z()));
    }
    EXPECT_LT(thickest, 1.1 * spacing);
    EXPECT_LT(checks::rmsDistance(points, surface), spacing);
  }
}

TEST(PointSurface, PointsGivenTwiceCountOnce)
{
  const std::vector<Vec3> points = icosphere(3).points;
  std::vector<Vec3> twice = points;
  twice.insert(twice.end(), points.begin(), points.end());
  EXPECT_TRUE(amidst(twice) == amidst(points));
}

TEST(PointSurface, OrderOfThePointsDoesNotMatter)
{
  std::vector<Vec3> points = shapes::bumpySphere(4).points;
  const SurfaceMesh one = amidst(points);
  std::shuffle(points.begin(), points.end(), std::mt19937(7));
  const SurfaceMesh other = amidst(points);
  wraps::expectSound(other, 0);
  EXPECT_NEAR(other.vertexCount(), one.vertexCount(), 0.03 * one.vertexCount());
  EXPECT_NEAR(signedVolume(other), signedVolume(one), 1e-3 * signedVolume(one));
  EXPECT_NEAR(checks::rmsDistance(points, other), checks::rmsDistance(points, one), 0.002);
}

TEST(PointSurface, NoiseIsAveraged)
{
  std::vector<Vec3> points = icosphere(4).points;
  std::mt19937 generator(2);
  std::normal_distribution<double> noise(0.0, 0.01);
  for (Vec3& p : points)
  {
    p *= 1.0 + noise(generator);
  }
  const SurfaceMesh surface = amidst(points);
  wraps::expectSound(surface, 0, 1, 20.0);
  double squares = 0.0;
  for (const Vec3& p : surface.points)
  {
    squares += std::pow(p.norm() - 1.0, 2.0);
  }
  EXPECT_LT(std::sqrt(squares / surface.vertexCount()), 0.01);
}

TEST(PointSurface, FewPointsAreRefusedInOneSentence)
{
  const std::vector<std::vector<Vec3>> sets = { { Vec3::Zero(), Vec3::UnitX() },
    { Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY() },
    { Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitX() } };
  for (const std::vector<Vec3>& points : sets)
  {
    try
    {
      amidst(points);
      FAIL() << "expected a refusal of " << points.size();
    }
    catch (const InputError& error)
    {
      EXPECT_NE(std::string(error.what()).find("different points"), std::string::npos);
      EXPECT_EQ(std::string(error.what()).back(), '.');
    }
  }
}

TEST(PointSurface, PointsOnALineAreRefusedAnywhere)
{
  for (const double scale : { 1e-30, 1.0, 1e30 })
  {
    for (const Vec3& shift : { Vec3(Vec3::Zero()), Vec3(300.0, -500.0, 200.0) })
    {
      std::vector<Vec3> points;
      for (int i = 0; i < 50; ++i)
      {
        points.emplace_back(scale * (i * Vec3(0.1, -0.2, 0.3) + shift));
      }
      EXPECT_THROW(amidst(points), InputError);
    }
  }
}

TEST(PointSurface, FourPointsOfATetrahedronAreEnough)
{
  const SurfaceMesh surface = amidst({ Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ() });
  const TopologySummary topology = summarizeTopology(surface);
  EXPECT_TRUE(topology.isClosed() && topology.isManifold() && topology.isOriented());
  EXPECT_GT(signedVolume(surface), 0.0);
}

TEST(PointSurface, ACoarseGridIsRefusedAndNeverBlowsTheSurfaceUp)
{
  std::vector<Vec3> points = icosphere(1).points; // 42, which a wide gap makes wider
  int made = 0;
  for (const int samples : { 8, 10, 12, 16, 24, 40 })
  {
    for (const double gap : { 0.0, 0.4, 2.0, 1e30 })
    {
      ShrinkWrapOptions options = wraps::quick(0.15, samples);
      options.gapSize = gap;
      try
      {
        const Vec3 sizes = boundingBox(surfaceAmidst(pointSet(points), options)).sizes();
        EXPECT_LT(sizes.maxCoeff(), 3.5) << samples << " samples, gap " << gap; // points have 2
        ++made;
      }
      catch (const InputError& error)
      {
        const std::string sentence = error.what();
        EXPECT_TRUE(samples < 12 || gap > 1.0) << sentence;
        EXPECT_NE(sentence.find("SampleDimensions"), std::string::npos) << sentence;
        EXPECT_NE(sentence.find("set " + std::string(gap > 1.0 && samples > 10 ? "a smaller" : "")),
          std::string::npos)
          << sentence;
      }
    }
  }
  EXPECT_GE(made, 8);
}

TEST(PointSurface, IsTheSameOnAnyThreads)
{
  const std::vector<Vec3> points = icosphere(3).points;
  const SurfaceMesh serial = amidst(points);
  for (const int threads : { 2, 4 })
  {
    EXPECT_TRUE(amidst(points, threadedExecution(threads, 5)) == serial);
  }
}

} // namespace
