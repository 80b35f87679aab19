// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/ControlFunctions.h"

#include "Evolution/EdgeDetector.h"
#include "Evolution/EvolutionFields.h"
#include "Shapes/SampledOnGrid.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace evolving;

namespace
{

FlowOptions exampleOptions()
{
  FlowOptions options;
  options.curvatureSpeed = 2.0;
  options.curvatureRange = 0.5;
  options.advectionSpeed = 3.0;
  options.advectionBalance = 0.25;
  options.relativeUnits = false;
  return options;
}

ControlValues evaluateAt(const ControlField& field, const Vec3& point, const Vec3& normal)
{
  return field.evaluate({ point }, { normal }, Execution());
}

} // namespace

TEST(ControlFunctions, EpsilonFollowsTheDistance)
{
  EXPECT_EQ(curvatureControl(0.0, 2.0, 0.5), 0.0);
  EXPECT_NEAR(curvatureControl(0.5, 2.0, 0.5), 2.0 * (1.0 - std::exp(-0.5)), 1e-14);
  EXPECT_EQ(curvatureControl(-0.5, 2.0, 0.5), curvatureControl(0.5, 2.0, 0.5));
  EXPECT_NEAR(curvatureControl(1e3, 2.0, 0.5), 2.0, 1e-14);
  // d^2 / C2 for small d, without cancellation.
  EXPECT_NEAR(curvatureControl(1e-9, 1.0, 1.0), 1e-18, 1e-30);
}

TEST(ControlFunctions, EtaPullsTowardsTheTarget)
{
  // Outside and the gradient along the normal: inwards; inside: outwards.
  EXPECT_NEAR(advectionControl(0.4, -1.0, 3.0, 0.25), -1.2, 1e-14);
  EXPECT_NEAR(advectionControl(-0.4, -1.0, 3.0, 0.25), 1.2, 1e-14);
  // A surface that runs along the gradient around its target still moves inwards with D.
  EXPECT_NEAR(advectionControl(0.4, 0.0, 3.0, 0.25), -0.3, 1e-14);
  EXPECT_EQ(advectionControl(0.4, 0.0, 3.0, 0.0), 0.0);
  EXPECT_NEAR(advectionControl(0.4, -0.6, 1.0, 0.5), 0.4 * (-0.6 - 0.5 * 0.8), 1e-14);
  EXPECT_EQ(advectionControl(0.0, -1.0, 3.0, 0.25), 0.0);
}

TEST(ControlFunctions, SmoothingDecaysWithTheStep)
{
  EXPECT_EQ(smoothingControl(0.3, 0.1, 0), 0.3);
  EXPECT_NEAR(smoothingControl(0.3, 0.1, 10), 0.3 * std::exp(-1.0), 1e-15);
}

TEST(ControlField, EvaluatesTheDistanceFlow)
{
  const ControlField field(shapes::sphereField(41, 2.0, 0.5), exampleOptions());
  const Vec3 p(1.2, 0.0, 0.0);
  const Vec3 oblique = Vec3(1, 1, 0).normalized();
  const ControlValues values = evaluateAt(field, p, oblique);
  EXPECT_NEAR(values.value[0], 0.7, 1e-3);
  EXPECT_LT((values.gradient[0] - Vec3::UnitX()).norm(), 1e-3);
  EXPECT_NEAR(values.epsilon[0], curvatureControl(0.7, 2.0, 0.5), 2e-3);
  EXPECT_NEAR(values.eta[0], advectionControl(0.7, -std::sqrt(0.5), 3.0, 0.25), 5e-3);
}

TEST(ControlField, AVanishingGradientHasNoSlope)
{
  const auto flat = shapes::image(shapes::cubicGrid(5, 1.0), [](const Vec3&) { return 0.3; });
  const ControlField field(flat, exampleOptions());
  const ControlValues values = evaluateAt(field, Vec3::Zero(), Vec3::UnitZ());
  EXPECT_EQ(values.gradient[0], Vec3(Vec3::Zero()));
  EXPECT_NEAR(values.eta[0], advectionControl(0.3, 0.0, 3.0, 0.25), 1e-6);
}

TEST(ControlField, AnUnsignedFieldHasNoBalanceNearItsTarget)
{
  FlowOptions options = exampleOptions();
  options.unsignedField = true;
  const auto image = shapes::sphereField(41, 2.0, 0.5); // cells of 0.1
  const ControlField field(image, options);
  const Vec3 across = Vec3::UnitY();
  EXPECT_NEAR(evaluateAt(field, Vec3(0.65, 0, 0), across).eta[0], 0.0, 1e-4);
  EXPECT_NEAR(evaluateAt(field, Vec3(0.85, 0, 0), across).eta[0], -3.0 * 0.35 * 0.25, 1e-2);
  const ControlField with(image, exampleOptions());
  EXPECT_NEAR(evaluateAt(with, Vec3(0.65, 0, 0), across).eta[0], -3.0 * 0.15 * 0.25, 1e-2);
}

TEST(ControlField, WithoutAFieldIsMeanCurvatureFlow)
{
  const ControlField field(nullptr, exampleOptions());
  const ControlValues values = evaluateAt(field, Vec3(1, 2, 3), Vec3::UnitX());
  EXPECT_TRUE(values.value.empty());
  EXPECT_EQ(values.epsilon[0], 2.0);
  EXPECT_EQ(values.eta[0], 0.0);
}

TEST(ControlField, SmoothingKeepsTheDistances)
{
  const ControlField field(shapes::sphereField(41, 2.0, 0.5), exampleOptions());
  const ControlValues values = field.evaluateSmoothing({ Vec3(1, 0, 0) }, 0.7, Execution());
  EXPECT_EQ(values.epsilon[0], 0.7);
  EXPECT_EQ(values.eta[0], 0.0);
  EXPECT_NEAR(values.value[0], 0.5, 1e-3);
}

TEST(ControlField, EvaluatesTheEdgeDetectorFlow)
{
  FlowOptions options = exampleOptions();
  options.fieldMode = FieldMode::EdgeImage;
  const auto e = shapes::image(
    shapes::cubicGrid(21, 1.0), [](const Vec3& p) { return 0.5 + 0.1 * p.x() - 0.2 * p.y(); });
  const ControlField field(e, options);
  const ControlValues values = evaluateAt(field, Vec3(0.3, 0.1, 0), Vec3::UnitY());
  EXPECT_NEAR(values.epsilon[0], 2.0 * 0.51, 1e-6);
  EXPECT_NEAR(values.eta[0], -3.0 * -0.2, 1e-5);
}

TEST(EdgeDetector, IsSmallAtEdges)
{
  const auto ball = shapes::image(shapes::cubicGrid(41, 1.0),
    [](const Vec3& p) { return 1.0 / (1.0 + std::exp((p.norm() - 0.6) / 0.05)); });
  const ScalarImage e = edgeDetector(*ball, 2.0);
  EXPECT_NEAR(sampleEdgeDetector(e, Vec3::Zero()).value, 1.0, 1e-3);
  EXPECT_NEAR(sampleEdgeDetector(e, Vec3(1, 1, 1)).value, 1.0, 1e-3);
  // |grad I| is 5 in the middle of the edge, a little less by differences.
  EXPECT_NEAR(sampleEdgeDetector(e, Vec3(0.6, 0, 0)).value, 1.0 / (1.0 + 2.0 * 25.0), 0.02);
}

TEST(EdgeDetector, SeesNothingOutsideTheImage)
{
  const auto image =
    shapes::image(shapes::cubicGrid(11, 1.0), [](const Vec3& p) { return 2.0 + p.x(); });
  const ScalarImage::Sample sample = sampleEdgeDetector(*image, Vec3(4, 0.2, 0));
  EXPECT_NEAR(sample.value, 3.0, 1e-6);
  EXPECT_EQ(sample.gradient, Vec3(Vec3::Zero()));
}
