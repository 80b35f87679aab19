// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Children that crash, hang and eat memory, and what is reported of them.

#include "ChildProcess.h"
#include "Report.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <sstream>

namespace
{

using namespace robustness;

/// What becomes of work in a child.
ChildResult resultOf(const ChildPool::Work& work, const ChildLimits& limits = {})
{
  ChildPool pool(limits, work);
  pool.start(7);
  return pool.wait();
}

TEST(Children, HandTheirVerdictOn)
{
  const ChildResult result = resultOf(
    [](std::uint64_t seed, const Messenger& parent)
    {
      parent.describe("seed " + std::to_string(seed));
      parent.conclude({ Outcome::Wrong, Fault::Borders, "three\nedges" });
    });
  EXPECT_EQ(result.seed, 7u);
  EXPECT_EQ(result.description, "seed 7");
  EXPECT_EQ(result.verdict.outcome, Outcome::Wrong);
  EXPECT_EQ(result.verdict.fault, Fault::Borders);
  EXPECT_EQ(result.verdict.what, "three edges");
}

TEST(Children, MayCrash)
{
  const ChildResult result = resultOf(
    [](std::uint64_t, const Messenger& parent)
    {
      parent.describe("a crash");
      std::signal(SIGSEGV, SIG_DFL);
      std::raise(SIGSEGV);
    });
  EXPECT_EQ(result.verdict.outcome, Outcome::Crashed);
  EXPECT_EQ(result.description, "a crash");
}

TEST(Children, CrashWhenTheyEndWithoutAVerdict)
{
  EXPECT_EQ(resultOf([](std::uint64_t, const Messenger&) {}).verdict.outcome, Outcome::Crashed);
  const auto leave = [](std::uint64_t, const Messenger& parent)
  {
    parent.conclude({});
    std::_Exit(3);
  };
  EXPECT_EQ(resultOf(leave).verdict.outcome, Outcome::Crashed);
}

TEST(Children, MayTakeTooLong)
{
  ChildLimits limits;
  limits.cpuSeconds = 1;
  const auto spin = [](std::uint64_t, const Messenger&)
  {
    for (volatile bool forever = true; forever;)
    {
    }
  };
  EXPECT_EQ(resultOf(spin, limits).verdict.outcome, Outcome::TimedOut);
  limits.wallSeconds = 1;
  const auto sleep = [](std::uint64_t, const Messenger&) { std::raise(SIGSTOP); };
  EXPECT_EQ(resultOf(sleep, limits).verdict.outcome, Outcome::TimedOut);
}

TEST(Children, MayEatMemory)
{
  if (IsSanitized)
  {
    GTEST_SKIP() << "memory is not limited under sanitizers";
  }
  const auto eat = [](std::uint64_t, const Messenger& parent)
  {
    std::vector<std::vector<char>> all;
    for (;;)
    {
      all.emplace_back(std::size_t(1) << 26, 'x');
      parent.describe(std::to_string(all.size()));
    }
  };
  ChildLimits limits;
  limits.bytes = std::size_t(1) << 30;
  EXPECT_EQ(resultOf(eat, limits).verdict.outcome, Outcome::OutOfMemory);
}

TEST(Reports, AreGoodUntilSomethingIsBad)
{
  Report report;
  std::ostringstream out;
  report.add("MeshSDF", { 1, "a ball", { Outcome::Refused, Fault::None, "no" } }, out);
  EXPECT_TRUE(report.isGood());
  EXPECT_TRUE(out.str().empty());
  report.add("MeshSDF", { 2, "a torus", { Outcome::Wrong, Fault::WrongSign, "no" } }, out);
  EXPECT_FALSE(report.isGood());
  EXPECT_NE(out.str().find("seed 2"), std::string::npos);
  report.print(out);
  EXPECT_NE(out.str().find("wrong sign (13): seeds 2"), std::string::npos);
}

} // namespace
