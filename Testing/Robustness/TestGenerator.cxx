// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BaseShapes.h"
#include "Defects.h"
#include "Generator.h"
#include "SpecialModels.h"
#include "Subject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{

using namespace robustness;

constexpr std::uint64_t ManySeeds = 2000;

TEST(Generator, MakesTheSameInputOfTheSameSeed)
{
  for (std::uint64_t seed = 0; seed < 200; ++seed)
  {
    EXPECT_EQ(hashOf(makeModel(seed)), hashOf(makeModel(seed)));
  }
}

/// But for a few good shapes without any defect, which have little to choose.
TEST(Generator, MakesAnotherInputOfAnotherSeed)
{
  constexpr std::uint64_t Seeds = 500;
  std::set<std::uint64_t> hashes;
  for (std::uint64_t seed = 0; seed < Seeds; ++seed)
  {
    hashes.insert(hashOf(makeModel(seed)));
  }
  EXPECT_GT(hashes.size(), Seeds - Seeds / 20);
}

TEST(Generator, MakesEverythingItKnows)
{
  std::set<std::string> made;
  for (std::uint64_t seed = 0; seed < ManySeeds; ++seed)
  {
    const Model model = makeModel(seed);
    made.insert(model.story.begin(), model.story.end());
  }
  for (const auto* shapes : { &baseShapes(), &specialModels() })
  {
    for (const BaseShape& shape : *shapes)
    {
      EXPECT_EQ(made.count(shape.name), 1u) << shape.name;
    }
  }
  for (const auto* defects : { &faceDefects(), &partDefects(), &pointDefects() })
  {
    for (const Defect& defect : *defects)
    {
      EXPECT_EQ(made.count(defect.name), 1u) << defect.name;
    }
  }
}

/// The numbers themselves, which must not depend on a standard library.
TEST(RandomNumbers, AreTheSameEverywhere)
{
  std::mt19937_64 engine(4 * 5 + 1);
  Random random(5, Random::ForModel);
  EXPECT_EQ(random.index(1000), engine() % 1000);
  EXPECT_EQ(random.integer(-3, 3), -3 + static_cast<int>(engine() % 7));
  EXPECT_EQ(random.real(0.0, 1.0), std::ldexp(static_cast<double>(engine() >> 11), -53));
  std::mt19937_64 standard;
  standard.discard(9999);
  EXPECT_EQ(standard(), 9981545732273789042u); // as the standard has it
}

TEST(RandomNumbers, StayInTheirRange)
{
  Random random(1, Random::ForParameters);
  double mean = 0.0;
  for (int k = 0; k < 1000; ++k)
  {
    const double length = random.logarithmic(1e-12, 1e12);
    EXPECT_TRUE(length >= 0.99e-12 && length <= 1.01e12);
    EXPECT_NEAR(random.direction().norm(), 1.0, 1e-15);
    mean += std::log10(length) / 1000.0;
  }
  EXPECT_NEAR(mean, 0.0, 1.0);
}

/// What is said to bound a solid does: nothing is claimed that the judges would have to forgive.
TEST(BaseShapes, BoundTheSolidTheyClaim)
{
  int solids = 0;
  for (const BaseShape& shape : baseShapes())
  {
    for (std::uint64_t seed = 0; seed < 20; ++seed)
    {
      Random random(seed, Random::ForModel);
      const Model model = shape.make(random);
      const bool claims = !model.solid.empty();
      solids += claims ? 1 : 0;
      EXPECT_EQ(Subject(model).isSolid(), claims) << shape.name << ", seed " << seed;
    }
  }
  EXPECT_GT(solids, 150);
}

/// A defect that keeps the solid leaves it true; one that changes the shape forgets it.
TEST(Defects, KeepOrForgetTheSolid)
{
  const std::set<std::string> harmless{ "flips", "inside out", "duplicates", "reversed duplicates",
    "soup", "slivers", "caps", "no area", "strips", "lines and vertices", "unused points",
    "unused NaN" };
  for (const auto* defects : { &faceDefects(), &partDefects(), &pointDefects() })
  {
    for (const Defect& defect : *defects)
    {
      Random random(3, Random::ForModel);
      Model model = icosphere(1, 1.0, Vec3::Zero());
      const std::uint64_t before = hashOf(model);
      defect.make(model, random);
      EXPECT_NE(hashOf(model), before) << defect.name;
      EXPECT_FALSE(model.isClean) << defect.name;
      EXPECT_EQ(Subject(model).isSolid(), harmless.count(defect.name) > 0) << defect.name;
    }
  }
}

TEST(Subjects, KnowWhatIsDamaged)
{
  Model model = icosphere(0, 1.0, Vec3::Zero());
  EXPECT_TRUE(Subject(model).isUsable());
  EXPECT_TRUE(Subject(model).topology.isClosed());
  model.addPoint(Vec3(std::nan(""), 0.0, 0.0));
  EXPECT_FALSE(Subject(model).hasNaN);
  model.addPolygon({ 0, 1, 12 });
  EXPECT_TRUE(Subject(model).hasNaN);
  model.addPolygon({ 0, 1, 13 });
  EXPECT_TRUE(Subject(model).isDamaged);
}

} // namespace
