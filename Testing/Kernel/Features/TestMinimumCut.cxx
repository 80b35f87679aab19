// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/MinimumCut.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace evolving;

namespace
{

struct Edge
{
  Index a;
  Index b;
  double capacity;
};

double costOf(const std::vector<Edge>& edges, const std::vector<char>& side)
{
  double cost = 0.0;
  for (const Edge& edge : edges)
  {
    const bool cut =
      side[static_cast<std::size_t>(edge.a)] != side[static_cast<std::size_t>(edge.b)];
    cost += cut ? edge.capacity : 0.0;
  }
  return cost;
}

} // namespace

TEST(MinimumCut, OfAChainIsItsWeakestEdge)
{
  MinimumCut cut(4);
  cut.addEdge(0, 1, 3.0);
  cut.addEdge(1, 2, 1.0);
  cut.addEdge(2, 3, 2.0);
  EXPECT_EQ(cut.sourceSide(0, 3), (std::vector<char>{ 1, 1, 0, 0 }));
}

TEST(MinimumCut, LeavesApartWhatIsNotConnected)
{
  MinimumCut cut(3);
  cut.addEdge(0, 2, 1.0);
  EXPECT_EQ(cut.sourceSide(0, 1), (std::vector<char>{ 1, 0, 1 }));
}

TEST(MinimumCut, IsTheCheapestOfAllSubsets)
{
  constexpr Index Nodes = 9;
  std::mt19937 generator(4);
  std::uniform_int_distribution<Index> node(0, Nodes - 1);
  std::uniform_real_distribution<double> capacity(0.1, 1.0);
  for (int trial = 0; trial < 50; ++trial)
  {
    std::vector<Edge> edges;
    MinimumCut cut(Nodes);
    for (int e = 0; e < 20; ++e)
    {
      const Edge edge{ node(generator), node(generator), capacity(generator) };
      if (edge.a != edge.b)
      {
        edges.push_back(edge);
        cut.addEdge(edge.a, edge.b, edge.capacity);
      }
    }
    double cheapest = std::numeric_limits<double>::infinity();
    for (unsigned subset = 0; subset < (1u << (Nodes - 2)); ++subset)
    {
      std::vector<char> side{ 1, 0 };
      for (Index k = 0; k < Nodes - 2; ++k)
      {
        side.push_back((subset >> k) & 1);
      }
      cheapest = std::min(cheapest, costOf(edges, side));
    }
    const std::vector<char> found = cut.sourceSide(0, 1);
    EXPECT_EQ(found[0], 1);
    EXPECT_EQ(found[1], 0);
    EXPECT_NEAR(costOf(edges, found), cheapest, 1e-9);
  }
}
