// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/FieldCheck.h"

#include "Checks/Refusal.h"
#include "Evolution/EvolutionFields.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/SampledOnGrid.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace evolving;

namespace
{

using Function = std::function<double(const Vec3&)>;

/// The distance from a ball in cells of 0.1.
double ball(const Vec3& p)
{
  return p.norm() - 0.8;
}

/// What is said of a field; nothing when it may attract a surface.
std::string saidOf(const Function& function)
{
  const auto field = shapes::image(shapes::cubicGrid(33, 1.6), function);
  return checks::refusalOf([&] { checkDistance(*field); });
}

void expectSaid(const std::string& sentence, const std::string& part)
{
  EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("expected"), std::string::npos) << sentence;
  EXPECT_EQ(std::count(sentence.begin(), sentence.end(), '\n'), 0) << sentence;
}

} // namespace

TEST(FieldCheck, LetsDistancesPass)
{
  EXPECT_EQ(saidOf(ball), "");
  EXPECT_EQ(saidOf([](const Vec3& p) { return -ball(p); }), "");          // turned
  EXPECT_EQ(saidOf([](const Vec3& p) { return std::abs(ball(p)); }), ""); // unsigned
  EXPECT_EQ(saidOf([](const Vec3& p) { return p.norm(); }), "");          // from a point
  EXPECT_EQ(saidOf([](const Vec3& p) { return std::clamp(ball(p), -0.3, 0.3); }), ""); // a band
  EXPECT_EQ(saidOf([](const Vec3& p) { return shapes::torusDistance(p, 0.9, 0.3); }), "");
  // A plate that is thinner than a cell, and one that the samples pass by.
  for (const double half : { 0.02, 0.06 })
  {
    EXPECT_EQ(saidOf([&](const Vec3& p) { return shapes::boxDistance(p, Vec3(1, 1, half)); }), "");
  }
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 0.04);
  EXPECT_EQ(saidOf([&](const Vec3& p) { return ball(p) + noise(random); }), "");
}

TEST(FieldCheck, SaysWhatIsNoDistance)
{
  expectSaid(saidOf([](const Vec3& p) { return 100.0 * ball(p); }), "changes by 99");
  expectSaid(saidOf([](const Vec3& p) { return 0.1 * ball(p); }), "changes by 0.09");
  expectSaid(saidOf([](const Vec3& p) { return ball(p) < 0.0 ? 1.0 : 0.0; }), "but 0 and 1");
  expectSaid(saidOf([](const Vec3& p) { return ball(p) < 0.0 ? -1.0 : 1.0; }), "but -1 and 1");
  expectSaid(saidOf([](const Vec3& p) { return ball(p) < 0.0 ? (p.x() < 0.0 ? 1.0 : 3.0) : 0.0; }),
    "whole numbers from 0 to 3, as labels are");
  expectSaid(saidOf([](const Vec3& p) { return ball(p) < 0.0 ? 1.0 : 0.0; }), "vtkLabelSurfaces");
  expectSaid(saidOf([](const Vec3& p) { return ball(p) < 0.0 ? (p.x() < 0.0 ? 0.5 : -3.0) : 7.0; }),
    "changes by");
  expectSaid(
    saidOf([](const Vec3& p) { return -1000.0 + 1050.0 / (1.0 + std::exp(ball(p) / 0.1)); }),
    "changes by");
  expectSaid(saidOf([](const Vec3& p) { return ball(p) + 5.0; }), "which is zero somewhere");
  expectSaid(saidOf([](const Vec3& p) { return ball(p) - 5.0; }), "which is zero somewhere");
  expectSaid(saidOf([](const Vec3&) { return 3.0; }), "is 3 everywhere");
}

TEST(FieldCheck, DoesNotDependOnUnits)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const auto said = [&](double factor)
    {
      const auto field = shapes::image(shapes::cubicGrid(33, 1.6 * scale),
        [&](const Vec3& p) { return factor * (p.norm() - 0.8 * scale); });
      return checks::refusalOf([&] { checkDistance(*field); });
    };
    EXPECT_EQ(said(1.0), "");
    EXPECT_NE(said(10.0), "");
  }
}

TEST(FieldCheck, SaysWhereAFieldIsOfNoUse)
{
  const auto field = shapes::image(shapes::cubicGrid(17, 1.6), ball);
  const auto saidAt = [&](const Vec3& place)
  {
    const SurfaceMesh start = shapes::transformed(icosphere(2), 1.0, place);
    return checks::refusalOf([&] { checkFieldPlace(*field, start); });
  };
  EXPECT_EQ(saidAt(Vec3::Zero()), "");
  EXPECT_EQ(saidAt(Vec3(2.5, 0.0, 0.0)), "");
  expectSaid(saidAt(Vec3(10.0, 0.0, 0.0)), "[9, 11]");
  DistanceGrid slice = shapes::cubicGrid(17, 1.6);
  slice.extent[5] = slice.extent[4];
  expectSaid(checks::refusalOf([&] { checkFieldPlace(*shapes::image(slice, ball), icosphere(2)); }),
    "17 x 17 x 1");
}

TEST(FieldCheck, LetsImagesBeImages)
{
  const auto labels = shapes::image(
    shapes::cubicGrid(17, 1.6), [](const Vec3& p) { return ball(p) < 0.0 ? 1.0 : 0.0; });
  const auto saidAs = [&](FieldMode mode)
  { return checks::refusalOf([&] { checkField(*labels, icosphere(2), mode); }); };
  expectSaid(saidAs(FieldMode::DistanceField), "0 and 1");
  EXPECT_EQ(saidAs(FieldMode::Image), "");
}

TEST(FieldCheck, LetsPartsPassThatAreThinnerThanACell)
{
  // Rods of many directions, around which nearly all differences cancel.
  std::mt19937 random(3);
  std::vector<std::pair<Vec3, Vec3>> rods;
  for (int k = 0; k < 30; ++k)
  {
    rods.emplace_back(shapes::randomPoint(random), shapes::randomPoint(random));
  }
  EXPECT_EQ(saidOf(
              [&](const Vec3& p)
              {
                double least = 1e300;
                for (const auto& [a, b] : rods)
                {
                  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
                  least = std::min(least, (p - a - t * (b - a)).norm());
                }
                return least - 0.04;
              }),
    "");
}
