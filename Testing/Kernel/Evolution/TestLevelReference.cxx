// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/LevelReference.h"

#include "Evolution/EvolutionFields.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace evolving;

namespace
{

/// A sphere around another one, which is the target.
class AroundASphere : public ::testing::TestWithParam<double>
{
protected:
  const std::shared_ptr<const ScalarImage> Target = shapes::sphereField(81, 1.6, 0.6);
  const SurfaceMesh Surface = icosphere(4, GetParam());
  const LevelReference Levels{ *this->Target, this->Surface,
    std::vector<double>(this->Surface.points.size(), GetParam() - 0.6) };

  double radiusOfFoot(double radius) const
  {
    const Vec3 point = radius * Vec3(0.6, -0.48, 0.64);
    return this->Levels.onSurface(point, Vec3::UnitX(), 0, NoIndex).point.norm();
  }
};

} // namespace

TEST_P(AroundASphere, WhatIsFartherFromTheTargetGoesBack)
{
  const double away = std::abs(GetParam() - 0.6);
  for (const double off : { 0.02, 0.1 })
  {
    EXPECT_NEAR(std::abs(this->radiusOfFoot(0.6 + away + off) - 0.6), away, 1e-3);
    EXPECT_NEAR(std::abs(this->radiusOfFoot(0.6 - away - off) - 0.6), away, 1e-3);
  }
}

TEST_P(AroundASphere, WhatIsAsNearOrNearerStays)
{
  const double away = std::abs(GetParam() - 0.6);
  for (const double part : { 0.0, 0.5, 0.99 })
  {
    EXPECT_NEAR(this->radiusOfFoot(0.6 + part * away), 0.6 + part * away, 1e-3);
    EXPECT_NEAR(this->radiusOfFoot(0.6 - part * away), 0.6 - part * away, 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(LevelReference, AroundASphere, ::testing::Values(0.6, 0.8, 0.4));
