// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "MemoryCount.h"
#include "Remeshing/RemeshingShapes.h"
#include "ShrinkWrap/WrapRuns.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace
{

using namespace evolving;

constexpr int Samples = 100;

/// Boxes as wide as high, so that grids have all their samples.
struct Target
{
  SurfaceMesh mesh;
  ShrinkWrapOptions options;
};

std::vector<Target> targets()
{
  const ShrinkWrapOptions plain = wraps::quick(0.3, Samples);
  ShrinkWrapOptions closing = plain;
  closing.gapSize = 0.8;
  ShrinkWrapOptions fromSphere = plain;
  fromSphere.start = WrapStart::Icosphere;
  return { { icosphere(3), plain }, { icosphere(3), closing }, { icosphere(3), fromSphere } };
}

double bytesPerSample(const Target& target)
{
  const MemoryCount count;
  const ShrinkWrapProblem problem = prepareShrinkWrap(target.mesh, target.options);
  return static_cast<double>(count.peak()) / (Samples * Samples * Samples);
}

TEST(WrapMemory, IsWhatTheGuardCounts)
{
  if (!MemoryCount::isSupported())
  {
    GTEST_SKIP() << "nothing counts memory here";
  }
  double most = 0.0;
  for (const Target& target : targets())
  {
    const double bytes = bytesPerSample(target);
    most = std::max(most, bytes);
    EXPECT_LT(bytes, 1.05 * wrapBytesPerSample());
  }
  EXPECT_GT(most, 0.9 * wrapBytesPerSample());
}

TEST(WrapMemory, AReadyProblemHoldsOneGridAndItsReference)
{
  if (!MemoryCount::isSupported())
  {
    GTEST_SKIP() << "nothing counts memory here";
  }
  const Target target = targets()[0];
  const MemoryCount count;
  const ShrinkWrapProblem problem = prepareShrinkWrap(target.mesh, target.options);
  const auto held = static_cast<double>(count.held());
  const double grid = static_cast<double>(Samples * Samples * Samples) * sizeof(float);
  EXPECT_EQ(problem.field->values().size() * sizeof(float), grid);
  EXPECT_GT(held, grid);
  EXPECT_LT(held, 1.5 * grid); // four grids are there while it is made
  const auto counted = static_cast<double>(bytesOf(problem));
  EXPECT_NEAR(held, counted, 0.15 * counted); // less the start, which belongs to the states
}

} // namespace
