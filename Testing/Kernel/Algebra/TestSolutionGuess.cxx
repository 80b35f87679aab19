// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Algebra/SolutionGuess.h"

#include <gtest/gtest.h>

using namespace evolving;

TEST(SolutionGuess, RepeatsThenFollowsALineThenAParabola)
{
  SolutionGuess<double> guess;
  std::vector<double> x{ 7.0 }; // no solution yet: stays
  guess.extrapolate(x, Execution());
  EXPECT_EQ(x[0], 7.0);
  const auto guessAfter = [&](double solution)
  {
    x[0] = solution;
    guess.extrapolate(x, Execution());
    return x[0];
  };
  // The solutions are 2 k^2 - 3 k + 5.
  EXPECT_EQ(guessAfter(5.0), 5.0);
  EXPECT_EQ(guessAfter(4.0), 3.0);
  EXPECT_EQ(guessAfter(7.0), 14.0);
  EXPECT_EQ(guessAfter(14.0), 25.0);
  EXPECT_EQ(guessAfter(25.0), 40.0);
}
