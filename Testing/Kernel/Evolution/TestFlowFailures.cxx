// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Steps that fail leave what was reached before, whatever failed.

#include "Evolution/StateSeries.h"

#include "Checks/SurfaceMeasures.h"
#include "Errors.h"
#include "Evolution/FlowRuns.h"
#include "Evolution/Remeshers.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <new>
#include <set>
#include <string>

using namespace evolving;

namespace
{

constexpr std::size_t NoLimit = std::numeric_limits<std::size_t>::max();
constexpr int Steps = 8;
constexpr int BadStep = 4;

/// A flow that remeshes after every step, and what its remesher did.
struct FailingFlow
{
  std::function<void()> fail;
  int failsAt = BadStep; ///< the surface of that step and of later ones cannot be remeshed
  int failures = 0;

  SurfaceFlow operator()(const Execution& execution)
  {
    const auto start = std::make_shared<const SurfaceMesh>(icosphere(2));
    const auto remesher = remeshers::byRule(
      [this](const SurfaceMesh& mesh, const std::vector<double>& /*distance*/)
      {
        // r^2 = 1 - 4 t
        const double radius = checks::meanRadius(mesh);
        if (radius * radius < 1.0 - 0.008 * (this->failsAt - 0.5))
        {
          ++this->failures;
          this->fail();
        }
        return std::optional<SurfaceMesh>();
      });
    return SurfaceFlow(start, nullptr, remesher, flows::meanCurvatureFlow(0.002, Steps), execution);
  }
};

/// Expects steps up to the one before the bad one, and a sentence that holds a word.
void expectStop(FailingFlow flow, const std::string& word, int expectedFailures)
{
  StateSeries series([&flow](const Execution& host) { return flow(host); },
    publishedIterations(Steps, 0, 1), NoLimit, Execution());
  EXPECT_EQ(series.lastIteration(), BadStep - 1) << word;
  EXPECT_EQ(series.history().size(), std::size_t(BadStep)) << word;
  const std::string begin = "The evolution ended before step " + std::to_string(BadStep) + ": ";
  EXPECT_EQ(series.stopReason().find(begin), 0u) << series.stopReason();
  EXPECT_NE(series.stopReason().find(word), std::string::npos) << series.stopReason();
  EXPECT_EQ(flow.failures, expectedFailures) << word;
  SurfaceFlow undisturbed = FailingFlow{ [] {}, Steps + 1 }(Execution());
  for (std::size_t i = 0; i < std::size_t(BadStep); ++i)
  {
    const auto state = series.state(i, Execution());
    EXPECT_EQ(state->record.iteration, static_cast<int>(i)) << word;
    EXPECT_TRUE(state->points == undisturbed.mesh().points) << word;
    EXPECT_TRUE(state->arrays.coVolume == undisturbed.arrays().coVolume) << word;
    undisturbed.step();
  }
  EXPECT_EQ(series.state(Steps, Execution())->record.iteration, BadStep - 1) << word;
}

} // namespace

TEST(FlowFailures, OfAnyKindKeepWhatWasReached)
{
  expectStop({ [] { throw InputError("Too many triangles, expected fewer."); } }, "Too many", 1);
  expectStop({ [] { throw std::bad_alloc(); } }, "out of memory", 1);
  expectStop({ [] { throw std::length_error("vector"); } }, "vector", 1);
  expectStop({ [] { throw std::logic_error("a mistake."); } }, "a mistake", 1);
  // Shorter steps might help: five tries.
  expectStop({ [] { throw SolverError("not solved."); } }, "not solved", 5);
}

TEST(FlowFailures, ACancelledStepIsNone)
{
  FailingFlow maker{ [] { throw Cancelled(); } };
  SurfaceFlow flow = maker(Execution());
  EXPECT_THROW(flows::run(flow), Cancelled);
  EXPECT_EQ(flow.record().iteration, BadStep - 1);
  EXPECT_EQ(flow.stopReason(), "");
}

TEST(FlowFailures, AnInputThatNothingCanBeDoneWithIsRefused)
{
  FailingFlow maker{ [] { throw InputError("Too many triangles, expected fewer."); }, 1 };
  EXPECT_THROW(StateSeries([&maker](const Execution& host) { return maker(host); },
                 publishedIterations(Steps, 0, 1), NoLimit, Execution()),
    InputError);
}

TEST(FlowFailures, TheLastStateHasItsFinalElements)
{
  // In the fourth step the surface may not be remeshed, but afterwards that of the third.
  bool hasFailed = false;
  const auto remesher = remeshers::byRule(
    [&hasFailed](const SurfaceMesh& mesh, const std::vector<double>& /*distance*/)
    {
      const double radius = checks::meanRadius(mesh);
      if (radius * radius < 1.0 - 0.008 * (BadStep - 0.5))
      {
        hasFailed = true;
        throw InputError("Not these.");
      }
      return hasFailed ? std::make_optional(icosphere(1, radius)) : std::nullopt;
    });
  const auto start = std::make_shared<const SurfaceMesh>(icosphere(2));
  StateSeries series([&](const Execution& host)
    { return SurfaceFlow(start, nullptr, remesher, flows::meanCurvatureFlow(0.002, Steps), host); },
    publishedIterations(Steps, 0, 1), NoLimit, Execution());
  EXPECT_EQ(series.lastIteration(), BadStep - 1);
  const auto last = series.state(Steps, Execution());
  EXPECT_EQ(last->points.size(), 42u);
  EXPECT_EQ(last->record.iteration, BadStep - 1);
  EXPECT_EQ(series.history().back().area, last->record.area);
  EXPECT_TRUE(remeshers::fit(last->arrays, 42) || last->arrays.distance.empty());
  EXPECT_EQ(series.state(BadStep - 2, Execution())->points.size(), 162u);
}
