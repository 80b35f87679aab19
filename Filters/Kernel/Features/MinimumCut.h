// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The cheapest way to separate two nodes of a graph.
 */

#ifndef EVOLVING_MINIMUM_CUT_H
#define EVOLVING_MINIMUM_CUT_H

#include "Types.h"

#include <vector>

namespace evolving
{

/// An undirected graph; the maximal flow between two of its nodes by Dinic's algorithm (1970).
class MinimumCut
{
public:
  explicit MinimumCut(Index nodes);

  /// Cutting between two different nodes costs this much more. @param capacity positive
  void addEdge(Index a, Index b, double capacity);

  /// For every node whether it is on the source's side of the cheapest cut nearest to the source.
  std::vector<char> sourceSide(Index source, Index sink);

private:
  /// Half of an edge; the other half is beside it: number ^ 1.
  struct Arc
  {
    Index to;
    Index next;      ///< of the same node
    double capacity; ///< what is left of it
  };

  bool isOpen(Index arc) const { return this->Arcs[at(arc)].capacity > this->Negligible; }
  /// As far as the sink; all that can be reached when it cannot.
  void findLevels(Index source, Index sink);
  /// Is an arc of a node open and on a shortest way?
  bool leadsOn(Index node, Index arc, Index sink) const;
  /// Sends as much as fits along one shortest way; false when there is none left.
  bool augment(Index source, Index sink);

  std::vector<Arc> Arcs;
  std::vector<Index> FirstArc;
  std::vector<Index> CurrentArc;
  std::vector<Index> Levels; ///< steps from the source; NoIndex when cut off
  double Negligible = 0.0;
};

} // namespace evolving

#endif
