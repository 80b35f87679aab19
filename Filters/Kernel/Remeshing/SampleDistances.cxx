// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SampleDistances.h"

#include "ParallelLoops.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evolving
{

namespace
{

constexpr double Far = std::numeric_limits<double>::infinity();

std::vector<Index> usedFaces(const EditableSurface& surface)
{
  std::vector<Index> faces;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f))
    {
      faces.push_back(f);
    }
  }
  return faces;
}

} // namespace

SampleDistances::SampleDistances(const EditableSurface& surface, const std::vector<Vec3>& samples,
  double nearest, const Execution& execution)
  : Surface(surface)
  , SamplesOfFace(at(surface.faceSlots()))
{
  const std::vector<Index> faces = usedFaces(surface);
  if (faces.empty())
  {
    return;
  }
  const AABBTree tree(surface.mesh(), execution.phase(0.0, 0.5));
  std::vector<ClosestTriangle> closest(samples.size());
  execution.phase(0.5, 1.0).forRange(static_cast<std::int64_t>(samples.size()),
    Execution::MeshGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      Index guess = NoIndex;
      for (auto s = static_cast<std::size_t>(begin); s < static_cast<std::size_t>(end); ++s)
      {
        closest[s] = tree.closest(samples[s], Far, guess);
        guess = closest[s].triangle;
      }
    });
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    const Index face = faces[at(closest[s].triangle)];
    const double distance = std::sqrt(closest[s].at.squaredDistance);
    if (distance >= nearest * surface.size(surface.from(3 * face)))
    {
      this->Samples.push_back(samples[s]);
      this->Faces.push_back(face);
      this->Distances.push_back(distance);
    }
  }
  this->sortByFace();
}

void SampleDistances::update()
{
  for (std::size_t s = 0; s < this->count(); ++s)
  {
    double least = Far;
    Index closest = NoIndex;
    for (const Index f : this->facesAround(this->Faces[s]))
    {
      const Triangle triangle{ { this->Surface.corner(f, 0), this->Surface.corner(f, 1),
        this->Surface.corner(f, 2) } };
      const double squared = closestPointOnTriangle(this->Samples[s], triangle).squaredDistance;
      if (squared < least)
      {
        least = squared;
        closest = f;
      }
    }
    this->Faces[s] = closest;
    this->Distances[s] = std::sqrt(least);
  }
  this->sortByFace();
}

std::vector<Index> SampleDistances::facesAround(Index face) const
{
  std::vector<Index> faces;
  for (Index k = 0; k < 3; ++k)
  {
    this->Surface.forEachOutgoing(this->Surface.from(3 * face + k),
      [&](Index e) { faces.push_back(EditableSurface::faceOf(e)); });
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

void SampleDistances::sortByFace()
{
  for (std::vector<std::size_t>& samples : this->SamplesOfFace)
  {
    samples.clear();
  }
  for (std::size_t s = 0; s < this->count(); ++s)
  {
    this->SamplesOfFace[at(this->Faces[s])].push_back(s);
  }
}

} // namespace evolving
