// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LabelSurfaces/LabelNumbers.h"

#include "Checks/Refusal.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace evolving;

namespace
{

constexpr std::array<Index, 3> Sizes = { 2, 2, 2 };

NumberedLabels numbered(const std::vector<double>& values, const LabelChoice& choice = {})
{
  return numberLabels(
    Sizes, [&](GridIndex i) { return values[at(i)]; }, choice);
}

std::string refusal(const std::vector<double>& values, const LabelChoice& choice = {})
{
  return checks::refusalOf([&]() { numbered(values, choice); });
}

bool says(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST(LabelNumbers, AreThePlacesOfLabelsInAscendingOrder)
{
  const NumberedLabels result = numbered({ 7, 0, -3, 7, 1000, 0, 0, -3 });
  EXPECT_EQ(result.labels, (std::vector<double>{ -3, 7, 1000 }));
  EXPECT_EQ(result.materials, (std::vector<Material>{ 2, 0, 1, 2, 3, 0, 0, 1 }));
}

TEST(LabelNumbers, LeaveTheBackgroundOutWhateverItIs)
{
  const NumberedLabels result = numbered({ 7, 0, 0, 7, 7, 0, 0, 5 }, { {}, 7 });
  EXPECT_EQ(result.labels, (std::vector<double>{ 0, 5 }));
  EXPECT_EQ(result.materials, (std::vector<Material>{ 0, 1, 1, 0, 0, 1, 1, 2 }));
}

TEST(LabelNumbers, MakeBackgroundOfWhatWasNotChosen)
{
  const NumberedLabels result = numbered({ 1, 2, 3, 4, 1, 2, 3, 4 }, { { 4, 2, 4, 9 }, 0 });
  EXPECT_EQ(result.labels, (std::vector<double>{ 2, 4, 9 }));
  EXPECT_EQ(result.materials, (std::vector<Material>{ 0, 1, 0, 2, 0, 1, 0, 2 }));
}

TEST(LabelNumbers, RefuseWhatIsNoLabel)
{
  EXPECT_TRUE(says(refusal({ 0, 0, 0.5, 0, 0, 0, 0, 0 }), "0.5, expected labels"));
  EXPECT_TRUE(
    says(refusal({ 0, 0, std::numeric_limits<double>::quiet_NaN(), 0, 0, 0, 0, 0 }), "nan"));
  EXPECT_TRUE(
    says(refusal({ 0, 0, 1, 0, 3, 0, 0, 0 }, { { 7 }, 0 }), "none of the chosen labels 7"));
  EXPECT_TRUE(says(refusal({ 0, 0, 1, 0, 3, 0, 0, 0 }, { { 7 }, 0 }), "it has 1, 3"));
}

TEST(LabelNumbers, RefuseABackgroundThatIsNoWholeNumber)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(refusal(std::vector<double>(8, 1.0), { {}, none }), "BackgroundLabel is nan"));
  EXPECT_TRUE(says(refusal(std::vector<double>(8, 1.0), { {}, 0.5 }), "BackgroundLabel is 0.5"));
}

TEST(LabelNumbers, RefuseASlice)
{
  const auto ofSlice = [] { numberLabels({ 4, 4, 1 }, [](GridIndex) { return 1.0; }, {}); };
  EXPECT_TRUE(says(checks::refusalOf(ofSlice), "4 x 4 x 1 voxels"));
}

TEST(LabelNumbers, RefuseIntensitiesUnlessLabelsAreChosen)
{
  std::mt19937 generator(1);
  std::vector<double> values(1000);
  for (double& value : values)
  {
    value = static_cast<double>(generator() % 500);
  }
  const auto number = [&](const LabelChoice& choice)
  {
    return numberLabels(
      { 10, 10, 10 }, [&](GridIndex i) { return values[at(i)]; }, choice);
  };
  EXPECT_TRUE(says(checks::refusalOf([&]() { number({}); }), "neighbouring voxels differ"));
  EXPECT_EQ(number({ { values[5] }, -1 }).labels.size(), 1U);
}

TEST(LabelNumbers, RefuseMoreLabelsThanThereAreNumbers)
{
  const auto tooMany = [] {
    numberLabels({ 64, 64, 32 }, [](GridIndex i) { return static_cast<double>(i / 2); }, {});
  };
  EXPECT_TRUE(says(checks::refusalOf(tooMany), "more than 65534 labels"));
}
