// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LostTopology/ProbeGroups.h"

#include "Mesh/DisjointSets.h"

#include <algorithm>
#include <map>
#include <utility>

namespace evolving
{

namespace
{

/// A triangle and those that share a vertex with it. Across an edge alone would not do: of the two
/// triangles of each quad of a wall perhaps only one begins in what was closed.
std::vector<Index> trianglesAround(const MeshTopology& topology, Index triangle)
{
  std::vector<Index> around;
  for (Index k = 0; k < 3; ++k)
  {
    for (const Index corner : topology.ringCorners(topology.vertexOf(3 * triangle + k)))
    {
      around.push_back(topology.faceOf(corner));
    }
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  return around;
}

class Grouping
{
public:
  Grouping(const std::vector<MedialProbe>& probes, const ProbePlaces& places)
    : Probes(probes)
    , Reach(places.reach)
    , Sets(probes.size())
  {
    for (std::size_t i = 0; i < probes.size(); ++i)
    {
      this->OnTriangle[probes[i].triangle].push_back(static_cast<Index>(i));
    }
  }

  std::vector<std::vector<MedialProbe>> groups(const MeshTopology& topology)
  {
    for (Index i = 0; i < static_cast<Index>(this->Probes.size()); ++i)
    {
      const MedialProbe& probe = this->Probes[at(i)];
      this->joinAt(i, probe.to, probe.across, probe.across);
      for (const Index triangle : trianglesAround(topology, probe.triangle))
      {
        this->joinAt(i, probe.from, triangle, probe.triangle);
      }
    }
    std::map<Index, std::vector<MedialProbe>> byRoot;
    for (Index i = 0; i < static_cast<Index>(this->Probes.size()); ++i)
    {
      byRoot[this->Sets.find(i)].push_back(this->Probes[at(i)]);
    }
    std::vector<std::vector<MedialProbe>> result;
    for (auto& [root, group] : byRoot)
    {
      result.push_back(std::move(group));
    }
    return result;
  }

private:
  /// With those that begin near a point of a triangle, or of one next to it.
  void joinAt(Index i, const Vec3& point, Index triangle, Index nextTo)
  {
    const auto found = this->OnTriangle.find(triangle);
    if (found == this->OnTriangle.end())
    {
      return;
    }
    const double reach = this->Reach[at(nextTo)] + this->Reach[at(triangle)];
    for (const Index j : found->second)
    {
      if ((this->Probes[at(j)].from - point).squaredNorm() <= reach * reach)
      {
        this->Sets.join(i, j);
      }
    }
  }

  const std::vector<MedialProbe>& Probes;
  const std::vector<double>& Reach;
  DisjointSets Sets;
  std::map<Index, std::vector<Index>> OnTriangle;
};

} // namespace

std::vector<std::vector<MedialProbe>> groupedProbes(
  const std::vector<MedialProbe>& probes, const ProbePlaces& places, const MeshTopology& topology)
{
  return Grouping(probes, places).groups(topology);
}

} // namespace evolving
