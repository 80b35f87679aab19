// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/SurfaceFlow.h"

#include "Evolution/EvolutionFields.h"
#include "Evolution/EvolutionShapes.h"
#include "Evolution/FlowRuns.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(FlowInvariance, FollowsTranslationsAndScale)
{
  const Vec3 offset(1000.0, -500.0, 250.0);
  const double scale = 8.0; // a power of two: the same rounding
  const SurfaceMesh start = shapes::bumpySphere(2);
  const auto field = shapes::sphereField(31, 1.6, 0.5);
  DistanceGrid moved = field->grid();
  moved.origin = scale * moved.origin + offset;
  moved.spacing *= scale;
  std::vector<float> values = field->values();
  for (float& value : values)
  {
    value *= static_cast<float>(scale);
  }
  SurfaceFlow flow(start, field, flows::towardsSphere(20));
  SurfaceFlow other(shapes::transformed(start, scale, offset),
    std::make_shared<const ScalarImage>(moved, values), flows::towardsSphere(20));
  flows::run(flow);
  flows::run(other);
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    const Vec3 expected = scale * flow.mesh().points[i] + offset;
    EXPECT_LT((other.mesh().points[i] - expected).norm(), 1e-6 * scale);
  }
}
