// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LostTopology/ChangedPlaces.h"

#include "LostTopology/MedialProbes.h"
#include "LostTopology/ProbeGroups.h"
#include "Mesh/ConnectedComponents.h"

#include <algorithm>
#include <utility>

namespace evolving
{

namespace
{

std::vector<char> insideOf(
  const AABBTree& result, const std::vector<MedialProbe>& probes, const Execution& execution)
{
  std::vector<char> isInside(probes.size());
  execution.forRangeReporting(static_cast<std::int64_t>(probes.size()), Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        isInside[i] =
          result.hits(Ray(probes[i].middle(), askewDirection())).size() % 2 == 1 ? 1 : 0;
      }
    });
  return isInside;
}

std::vector<MedialProbe> chosen(
  const std::vector<MedialProbe>& probes, const std::vector<char>& isInside, char wanted)
{
  std::vector<MedialProbe> result;
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    if (isInside[i] == wanted)
    {
      result.push_back(probes[i]);
    }
  }
  return result;
}

/// Of probes, those that are nearest to the surface of the result say how wide a place is: behind a
/// mouth that was closed there may be a whole cavity.
constexpr std::size_t PartAtMouth = 10; // one of so many

ChangedPlace placeOf(const std::vector<MedialProbe>& group, const AABBTree& result)
{
  std::vector<std::pair<double, std::size_t>> depths;
  for (std::size_t i = 0; i < group.size(); ++i)
  {
    depths.emplace_back(result.closest(group[i].middle()).at.squaredDistance, i);
  }
  std::sort(depths.begin(), depths.end());
  depths.resize((depths.size() + PartAtMouth - 1) / PartAtMouth);
  Vec3 mean = Vec3::Zero();
  std::vector<double> widths;
  for (const auto& [depth, i] : depths)
  {
    mean += group[i].middle() / static_cast<double>(depths.size());
    widths.push_back(group[i].width());
  }
  const auto median = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), median, widths.end());
  // The mean itself may lie anywhere.
  const auto nearest = std::min_element(depths.begin(), depths.end(),
    [&](const auto& a, const auto& b)
    {
      return (group[a.second].middle() - mean).squaredNorm() <
        (group[b.second].middle() - mean).squaredNorm();
    });
  return { group[nearest->second].middle(), *median };
}

void sortByWidth(std::vector<ChangedPlace>& places)
{
  std::stable_sort(places.begin(), places.end(),
    [](const ChangedPlace& a, const ChangedPlace& b) { return a.width > b.width; });
}

class Comparison
{
public:
  Comparison(
    const SurfaceMesh& solid, const SurfaceMesh& result, double spacing, const Execution& execution)
    : Solid(solid)
    , Topology(solid)
    , SolidTree(solid, execution.phase(0.0, 0.1))
    , ResultTree(result, execution.phase(0.1, 0.2))
    , Places(probePlaces(solid, spacing))
    , Components(connectedComponents(solid))
    , Now(execution.phase(0.2, 1.0))
  {
  }

  ChangedPlaces run(std::size_t enoughFilled) const
  {
    ChangedPlaces changed;
    const std::vector<MedialProbe> front = this->probes(ProbeSide::Front, 0.0);
    changed.filled = this->placesOf(
      chosen(front, insideOf(this->ResultTree, front, this->Now.phase(0.4, 0.5)), 1));
    if (changed.filled.size() < enoughFilled)
    {
      this->findMissing(changed);
    }
    return changed;
  }

private:
  void findMissing(ChangedPlaces& changed) const
  {
    const std::vector<MedialProbe> behind = this->probes(ProbeSide::Behind, 0.5);
    const std::vector<char> isThere = insideOf(this->ResultTree, behind, this->Now.phase(0.9, 1.0));
    const std::vector<char> isLeft = this->partsWith(chosen(behind, isThere, 1));
    changed.missingParts = this->boxesOf(this->partsWith(behind), isLeft);
    std::vector<MedialProbe> missing = chosen(behind, isThere, 0);
    missing.erase(
      std::remove_if(missing.begin(), missing.end(),
        [&](const MedialProbe& probe) { return !isLeft[at(this->partOf(probe.triangle))]; }),
      missing.end());
    changed.missing = this->placesOf(missing);
  }

  std::vector<MedialProbe> probes(ProbeSide side, double from) const
  {
    return medialProbes(this->SolidTree, this->Places, side, this->Now.phase(from, from + 0.4));
  }

  Index partOf(Index triangle) const
  {
    return this->Components.ofVertex[at(this->Solid.faceVertex(triangle, 0))];
  }

  std::vector<char> partsWith(const std::vector<MedialProbe>& probes) const
  {
    std::vector<char> has(at(this->Components.count), 0);
    for (const MedialProbe& probe : probes)
    {
      has[at(this->partOf(probe.triangle))] = 1;
    }
    return has;
  }

  std::vector<ChangedPlace> placesOf(std::vector<MedialProbe> probes) const
  {
    probes.erase(std::remove_if(probes.begin(), probes.end(),
                   [&](const MedialProbe& probe) { return !isWidth(this->SolidTree, probe); }),
      probes.end());
    std::vector<ChangedPlace> places;
    for (const auto& group : groupedProbes(probes, this->Places, this->Topology))
    {
      places.push_back(placeOf(group, this->ResultTree));
    }
    sortByWidth(places);
    return places;
  }

  /// Of parts that are known, but not left.
  std::vector<ChangedPlace> boxesOf(
    const std::vector<char>& isKnown, const std::vector<char>& isLeft) const
  {
    std::vector<Box> boxes(at(this->Components.count));
    for (Index face = 0; face < this->Solid.faceCount(); ++face)
    {
      for (Index k = 0; k < 3; ++k)
      {
        boxes[at(this->partOf(face))].extend(this->Solid.facePoint(face, k));
      }
    }
    std::vector<ChangedPlace> places;
    for (std::size_t part = 0; part < boxes.size(); ++part)
    {
      if (isKnown[part] && !isLeft[part])
      {
        places.push_back({ boxes[part].center(), boxes[part].diagonal().norm() });
      }
    }
    sortByWidth(places);
    return places;
  }

  const SurfaceMesh& Solid;
  MeshTopology Topology;
  AABBTree SolidTree;
  AABBTree ResultTree;
  ProbePlaces Places;
  ConnectedComponents Components;
  Execution Now;
};

} // namespace

ChangedPlaces findChangedPlaces(const SurfaceMesh& solid, const SurfaceMesh& result, double spacing,
  std::size_t enoughFilled, const Execution& execution)
{
  return Comparison(solid, result, spacing, execution).run(enoughFilled);
}

} // namespace evolving
