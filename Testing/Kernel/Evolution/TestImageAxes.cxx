// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Images that are turned or mirrored: what is read from them is what is read from the same samples
// along the axes, turned.

#include "Evolution/ImageAxes.h"

#include "Errors.h"
#include "Evolution/EdgeDetector.h"
#include "Evolution/EvolutionFields.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/SurfaceFlow.h"
#include "Shapes/Draws.h"
#include "Shapes/SampledOnGrid.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace evolving;

namespace
{

using Matrix = Eigen::Matrix3d;

Matrix turn()
{
  return Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
}

Matrix mirroredTurn()
{
  return turn() * Vec3(1.0, -1.0, 1.0).asDiagonal();
}

/// Box-shaped cells, and nothing symmetric.
ScalarImage straight()
{
  DistanceGrid grid;
  grid.origin = Vec3(-1.0, 2.0, 0.5);
  grid.spacing = Vec3(0.25, 0.125, 0.5);
  grid.extent = { 2, 12, -3, 13, 0, 5 };
  const Vec3 middle = 0.5 * (grid.point(2, -3, 0) + grid.point(12, 13, 5));
  return ScalarImage(grid,
    shapes::sampled(
      grid, [&](const Vec3& p) { return (p - middle).cwiseQuotient(Vec3(3, 2, 2)).norm() - 0.2; }));
}

ScalarImage turned(const ScalarImage& image, const Matrix& directions)
{
  return ScalarImage(image.grid(), image.values(), ImageAxes(directions, image.grid().origin));
}

/// Points in the image and around it.
std::vector<Vec3> pointsAround(const ScalarImage& image)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-0.3, 1.3);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 at = shapes::drawnVector(part, random);
    points.push_back(image.box().min() + at.cwiseProduct(image.box().diagonal()));
  }
  return points;
}

void expectSame(
  const ScalarImage::Sample& found, const ScalarImage::Sample& expected, const Matrix& directions)
{
  EXPECT_NEAR(found.value, expected.value, 1e-12);
  EXPECT_LT((found.gradient - directions * expected.gradient).norm(), 1e-11);
}

bool isRefused(const Matrix& directions)
{
  try
  {
    ImageAxes(directions, Vec3::Zero());
    return false;
  }
  catch (const InputError& error)
  {
    const std::string sentence = error.what();
    return sentence.find("direction matrix") != std::string::npos && sentence.back() == '.';
  }
}

} // namespace

TEST(ImageAxes, SamplesAndContinuationTurnWithTheImage)
{
  const ScalarImage image = straight();
  for (const Matrix& directions : { turn(), mirroredTurn(), Matrix(Vec3(-1, -1, 1).asDiagonal()) })
  {
    const ScalarImage other = turned(image, directions);
    const Vec3 origin = image.grid().origin;
    for (const Vec3& p : pointsAround(image))
    {
      expectSame(other.at(origin + directions * (p - origin)), image.at(p), directions);
    }
    EXPECT_LT(
      (other.gradientAtSample(5, 2, 1) - directions * image.gradientAtSample(5, 2, 1)).norm(),
      1e-13);
  }
}

TEST(ImageAxes, AnEdgeDetectorTurnsWithItsImage)
{
  const ScalarImage image = straight();
  const ScalarImage other = turned(image, mirroredTurn());
  const ScalarImage e = edgeDetector(image, 2.0);
  const ScalarImage otherE = edgeDetector(other, 2.0);
  const Vec3 origin = image.grid().origin;
  for (const Vec3& p : pointsAround(image))
  {
    // The samples are floats.
    const ScalarImage::Sample expected = sampleEdgeDetector(e, p);
    const ScalarImage::Sample found =
      sampleEdgeDetector(otherE, origin + mirroredTurn() * (p - origin));
    EXPECT_NEAR(found.value, expected.value, 1e-6);
    EXPECT_LT((found.gradient - mirroredTurn() * expected.gradient).norm(), 1e-5);
  }
}

TEST(ImageAxes, TheBoxHoldsAllSamplesAndTheInsideKeepsItsSize)
{
  const ScalarImage image = straight();
  const ScalarImage other = turned(image, turn());
  const Vec3 origin = image.grid().origin;
  Box samples;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vec3 p = image.box().corner(static_cast<Box::CornerType>(corner));
    samples.extend(Vec3(origin + turn() * (p - origin)));
  }
  EXPECT_TRUE(other.box().isApprox(samples, 1e-13));
  EXPECT_EQ(other.insideBox().diagonal(), image.insideBox().diagonal());
  EXPECT_FALSE(image.insideBox().isEmpty());
}

TEST(ImageAxes, RoundingOfTheIdentityChangesNoBit)
{
  const ScalarImage image = straight();
  Matrix almost = Matrix::Identity();
  almost(0, 1) = 1e-16;
  almost(2, 2) = 1.0 - 1e-13;
  const ScalarImage other = turned(image, almost);
  EXPECT_TRUE(other.axes().areTheWorlds());
  for (const Vec3& p : pointsAround(image))
  {
    EXPECT_EQ(other.at(p).value, image.at(p).value);
    EXPECT_EQ(other.at(p).gradient, image.at(p).gradient);
  }
}

TEST(ImageAxes, RoundedDirectionsOfFilesAreMadeOrthogonal)
{
  // Six digits, as in headers of files.
  const Matrix rounded = (1e6 * mirroredTurn()).array().round() / 1e6;
  const ImageAxes axes(rounded, Vec3(1, 2, 3));
  const Vec3 along = axes.vectorToWorld(Vec3(3, -4, 12));
  EXPECT_NEAR(along.norm(), 13.0, 1e-13);
  EXPECT_LT((along - mirroredTurn() * Vec3(3, -4, 12)).norm(), 1e-4);
  EXPECT_LT((axes.pointFromWorld(axes.pointToWorld(Vec3(7, 8, 9))) - Vec3(7, 8, 9)).norm(), 1e-13);
}

TEST(ImageAxes, MatricesThatAreNoRotationAreRefused)
{
  Matrix sheared = Matrix::Identity();
  sheared(0, 1) = 0.1;
  Matrix unknown = turn();
  unknown(1, 1) = std::numeric_limits<double>::quiet_NaN();
  Matrix infinite = turn();
  infinite(2, 0) = std::numeric_limits<double>::infinity();
  Matrix singular = Matrix::Identity();
  singular(2, 2) = 0.0;
  for (const Matrix& bad : { sheared, unknown, infinite, singular, Matrix(Matrix::Zero()),
         Matrix(2.0 * Matrix::Identity()) })
  {
    EXPECT_TRUE(isRefused(bad)) << bad;
  }
  EXPECT_FALSE(isRefused(turn()));
  EXPECT_FALSE(isRefused(mirroredTurn()));
}

/// The flow of a turned start in the turned field is the turned flow, with the same numbers.
void expectTurnedFlow(
  const ScalarImage& image, const FlowOptions& options, const Matrix& directions, double tolerance)
{
  const Vec3 origin = image.grid().origin;
  const SurfaceMesh start = shapes::bumpySphere(2);
  SurfaceMesh other = directions.determinant() < 0.0 ? reversed(start) : start;
  for (Vec3& point : other.points)
  {
    point = origin + directions * (point - origin);
  }
  SurfaceFlow first(start, std::make_shared<const ScalarImage>(image), options);
  SurfaceFlow second(
    other, std::make_shared<const ScalarImage>(turned(image, directions)), options);
  flows::run(first);
  flows::run(second);
  ASSERT_EQ(first.stopReason() + second.stopReason(), "");
  EXPECT_GT((first.mesh().points[0] - start.points[0]).norm(), 0.01);
  EXPECT_NEAR(second.lengthUnit(), first.lengthUnit(), 1e-12);
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    const Vec3 expected = origin + directions * (first.mesh().points[i] - origin);
    ASSERT_LT((second.mesh().points[i] - expected).norm(), tolerance);
  }
  EXPECT_NEAR(second.record().area, first.record().area, 10.0 * tolerance);
  EXPECT_NEAR(second.record().volume, first.record().volume, 10.0 * tolerance);
  EXPECT_NEAR(second.record().maxDistance, first.record().maxDistance, tolerance);
  EXPECT_NEAR(second.record().meanDistance, first.record().meanDistance, tolerance);
}

TEST(ImageAxes, AFlowTurnsWithItsField)
{
  const auto image = shapes::image(shapes::cubicGrid(33, 1.6),
    [](const Vec3& p) { return (p - Vec3(0.05, 0.02, -0.03)).norm() - 0.5; });
  const FlowOptions options = flows::towardsSphere(20);
  expectTurnedFlow(*image, options, turn(), 1e-10);
  expectTurnedFlow(*image, options, mirroredTurn(), 1e-10);
}

TEST(ImageAxes, ASegmentationTurnsWithItsImage)
{
  const auto image = shapes::image(shapes::cubicGrid(33, 1.6),
    [](const Vec3& p) { return std::tanh(8.0 * ((p - Vec3(0.1, 0.0, 0.0)).norm() - 0.6)); });
  FlowOptions options = flows::towardsSphere(20);
  options.fieldMode = FieldMode::Image;
  options.edgeSharpness = 1.0;
  options.relativeUnits = false; // L is the start's box, which is along the world's axes
  expectTurnedFlow(*image, options, turn(), 1e-5); // its samples are floats
}
