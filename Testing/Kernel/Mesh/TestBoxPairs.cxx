// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Mesh/BoxPairs.h"

#include "Errors.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "ThreadedExecution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace evolving
{

using namespace evolving::shapes;

namespace
{

bool everyPair(Index, Index)
{
  return true;
}

std::vector<IndexPair> allPairsReference(const std::vector<Box>& boxes)
{
  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
    {
      if (boxes[i].intersects(boxes[j]))
      {
        pairs.emplace_back(static_cast<Index>(i), static_cast<Index>(j));
      }
    }
  }
  return pairs;
}

/// Sizes from about 1e-6 to 1, all decades alike; now and then an empty box.
std::vector<Box> unevenBoxes(int count, std::mt19937& generator)
{
  std::uniform_real_distribution<double> decade(-6.0, 0.0);
  std::vector<Box> boxes(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    if (i % 17 != 3)
    {
      const Vec3 a = randomPoint(generator);
      boxes[static_cast<std::size_t>(i)].extend(a);
      boxes[static_cast<std::size_t>(i)].extend(
        Vec3(a + std::pow(10.0, decade(generator)) * randomPoint(generator)));
    }
  }
  return boxes;
}

TEST(BoxPairs, AgreeWithAllPairsForAnyNumberAndSize)
{
  std::mt19937 generator(31);
  for (int count = 0; count <= 20; ++count)
  {
    const std::vector<Box> boxes = unevenBoxes(count, generator);
    EXPECT_EQ(overlappingPairs(boxes, everyPair), allPairsReference(boxes)) << count << " boxes";
  }
  for (const int count : { 100, 777, 2000 })
  {
    const std::vector<Box> boxes = unevenBoxes(count, generator);
    const std::vector<IndexPair> expected = allPairsReference(boxes);
    EXPECT_GE(expected.size(), static_cast<std::size_t>(count) / 50);
    EXPECT_EQ(overlappingPairs(boxes, everyPair), expected) << count << " boxes";
  }
}

TEST(BoxPairs, TouchingBoxesAndEqualBoxesCount)
{
  const Box box(Vec3(0, 0, 0), Vec3(1, 1, 1));
  const std::vector<Box> boxes{ box, Box(Vec3(1, 1, 1), Vec3(2, 2, 2)), box, Box(Vec3(3, 0, 0)),
    box, Box(Vec3(3, 0, 0)), box };
  EXPECT_EQ(overlappingPairs(boxes, everyPair), allPairsReference(boxes));
  EXPECT_EQ(overlappingPairs(boxes, everyPair).size(), 11U);
}

TEST(BoxPairs, OnlyWantedPairsAreKept)
{
  std::mt19937 generator(37);
  const std::vector<Box> boxes = unevenBoxes(500, generator);
  const auto isOddSum = [](Index i, Index j) { return (i + j) % 2 == 1; };
  std::vector<IndexPair> expected;
  for (const IndexPair& pair : allPairsReference(boxes))
  {
    EXPECT_LT(pair.first, pair.second);
    if (isOddSum(pair.first, pair.second))
    {
      expected.push_back(pair);
    }
  }
  EXPECT_EQ(overlappingPairs(boxes, isOddSum), expected);
}

TEST(BoxPairs, AreTheSameForAnyThreads)
{
  std::mt19937 generator(41);
  const std::vector<Box> boxes = unevenBoxes(3000, generator);
  const std::vector<IndexPair> serial = overlappingPairs(boxes, everyPair);
  for (const int threads : { 2, 8 })
  {
    EXPECT_EQ(overlappingPairs(boxes, everyPair, threadedExecution(threads, 3)), serial);
  }
}

TEST(BoxPairs, StopWhenAsked)
{
  std::mt19937 generator(43);
  const std::vector<Box> boxes = unevenBoxes(3000, generator);
  const Execution stopping(nullptr, nullptr, [] { return true; });
  EXPECT_THROW(overlappingPairs(boxes, everyPair, stopping), Cancelled);
}

TEST(BoxPairs, BoxesOverlappingAFewAreFoundInOrder)
{
  std::mt19937 generator(37);
  for (const int count : { 0, 1, 3, 40, 300 })
  {
    const std::vector<Box> few = unevenBoxes(count, generator);
    const std::vector<Box> others = unevenBoxes(10000, generator);
    std::vector<std::vector<Index>> expected(few.size());
    for (std::size_t i = 0; i < few.size(); ++i)
    {
      for (std::size_t j = 0; j < others.size(); ++j)
      {
        if (few[i].intersects(others[j]))
        {
          expected[i].push_back(static_cast<Index>(j));
        }
      }
    }
    EXPECT_EQ(boxesOverlapping(few, others), expected);
    EXPECT_EQ(boxesOverlapping(few, others, threadedExecution(8, 5)), expected);
  }
}

} // namespace

} // namespace evolving
