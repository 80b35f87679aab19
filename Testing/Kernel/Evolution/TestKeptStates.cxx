// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Evolution/KeptStates.h"

#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <limits>

using namespace evolving;

namespace
{

using State = std::shared_ptr<const FlowState>;

/// With a point, and an origin that some states share.
State stateOf(int iteration, int statesPerOrigin = std::numeric_limits<int>::max())
{
  static std::shared_ptr<const SurfaceMesh> origin;
  if (iteration % statesPerOrigin == 0)
  {
    origin = std::make_shared<const SurfaceMesh>(icosphere(0));
  }
  FlowState state;
  state.origin = origin;
  state.points = { Vec3::Zero() };
  state.record.iteration = iteration;
  return std::make_shared<const FlowState>(state);
}

const std::size_t OneState = sizeof(Vec3);
const std::size_t OneOrigin = bytesOf(icosphere(0));

/// As held by the states that are kept, counted one by one.
std::size_t countedBytes(const KeptStates& states)
{
  std::size_t bytes = 0;
  State before;
  for (std::size_t i = 0; i < states.size(); ++i)
  {
    const State& state = states.upTo(i);
    if (state != before)
    {
      bytes += bytesOf(*state);
      bytes += before && before->origin == state->origin ? 0 : bytesOf(*state->origin);
      before = state;
    }
  }
  return bytes;
}

} // namespace

TEST(KeptStates, KeepsAllThatFit)
{
  KeptStates states(10 * OneState + OneOrigin);
  for (int i = 0; i < 10; ++i)
  {
    states.append(stateOf(i));
    EXPECT_TRUE(states.areAll());
  }
  EXPECT_EQ(states.bytes(), 10 * OneState + OneOrigin);
  states.append(stateOf(10));
  EXPECT_FALSE(states.areAll());
}

TEST(KeptStates, KeepsEverySecondOfThoseThatDoNotFit)
{
  KeptStates states(10 * OneState + OneOrigin);
  for (int i = 0; i < 30; ++i)
  {
    states.append(stateOf(i));
    EXPECT_EQ(states.upTo(0)->record.iteration, 0);
    EXPECT_EQ(states.last()->record.iteration, i);
    EXPECT_LE(states.bytes(), 10 * OneState + OneOrigin);
    EXPECT_EQ(states.bytes(), countedBytes(states));
  }
  // 0, 4, ..., 28 and the last.
  EXPECT_EQ(states.upTo(7)->record.iteration, 4);
  EXPECT_EQ(states.upTo(8)->record.iteration, 8);
  EXPECT_EQ(states.upTo(28)->record.iteration, 28);
  EXPECT_EQ(states.upTo(29)->record.iteration, 29);
}

TEST(KeptStates, CountsSharedOriginsOnce)
{
  for (const int statesPerOrigin : { 1, 2, 3, 7, 100 })
  {
    for (const std::size_t limit : { std::size_t(0), 8 * (OneState + OneOrigin) })
    {
      KeptStates states(limit);
      for (int i = 0; i < 100; ++i)
      {
        states.append(stateOf(i, statesPerOrigin));
        EXPECT_EQ(states.bytes(), countedBytes(states)) << statesPerOrigin << " " << i;
        states.replaceLast(stateOf(i, statesPerOrigin));
        EXPECT_EQ(states.bytes(), countedBytes(states)) << statesPerOrigin << " " << i;
      }
    }
  }
}

TEST(KeptStates, WhatDroppingCostsCountsOnceOneIsDropped)
{
  const std::size_t room = 10 * OneState + OneOrigin;
  KeptStates states(room, 6 * OneState);
  for (int i = 0; i < 10; ++i)
  {
    states.append(stateOf(i));
  }
  EXPECT_TRUE(states.areAll());
  states.append(stateOf(10));
  EXPECT_LE(states.bytes(), 4 * OneState + OneOrigin);
  KeptStates none(room, 2 * room);
  for (int i = 0; i < 100; ++i)
  {
    none.append(stateOf(i));
  }
  EXPECT_EQ(none.bytes(), 2 * OneState + OneOrigin); // the ends
}

TEST(KeptStates, TakesConstantTimeForAState)
{
  constexpr int Count = 20000;
  for (const std::size_t kept : { std::size_t(0), std::size_t(10), std::size_t(5000) })
  {
    KeptStates states(kept * OneState);
    for (int i = 0; i < Count; ++i)
    {
      states.append(stateOf(i));
    }
    EXPECT_FALSE(states.areAll());
    EXPECT_LT(states.revisits(), std::size_t(Count)) << kept;
  }
}
