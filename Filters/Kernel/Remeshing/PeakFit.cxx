// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/PeakFit.h"

#include "Distance/AABBTree.h"
#include "ParallelLoops.h"
#include "Remeshing/Barycentric.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/SurfaceFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

constexpr double Pi = 3.14159265358979323846;
/// Fractions of the way to a peak that are tried.
constexpr std::array<double, 4> Fractions = { 1.0, 0.7, 0.45, 0.25 };
/// The larger distance must fall to this fraction.
constexpr double LeastGain = 0.97;
/// No face may turn by more than 45 degrees.
constexpr double LeastCosine = 0.7;

Triangle triangleOf(const EditableSurface& surface, Index f)
{
  return { { surface.corner(f, 0), surface.corner(f, 1), surface.corner(f, 2) } };
}

/// Which face is closest to each sample, and how far away it is: NoIndex and infinitely far when
/// there is no face.
struct SampleDistances
{
  std::vector<Index> face;
  std::vector<double> distance;

  SampleDistances(
    const EditableSurface& surface, const std::vector<Vec3>& samples, const Execution& execution)
    : face(samples.size(), NoIndex)
    , distance(samples.size(), std::numeric_limits<double>::infinity())
  {
    std::vector<Index> slot;
    for (Index f = 0; f < surface.faceSlots(); ++f)
    {
      if (surface.hasFace(f))
      {
        slot.push_back(f);
      }
    }
    if (slot.empty())
    {
      return;
    }
    const AABBTree tree(surface.mesh(), execution.phase(0.0, 0.5));
    execution.phase(0.5, 1.0).forRange(static_cast<std::int64_t>(samples.size()),
      Execution::MeshGrain,
      [&](std::int64_t begin, std::int64_t end)
      {
        Index guess = NoIndex;
        for (auto s = static_cast<std::size_t>(begin); s < static_cast<std::size_t>(end); ++s)
        {
          const ClosestTriangle closest =
            tree.closest(samples[s], std::numeric_limits<double>::infinity(), guess);
          guess = closest.triangle;
          this->face[s] = slot[at(guess)];
          this->distance[s] = std::sqrt(closest.at.squaredDistance);
        }
      });
  }
};

class PeakSearch
{
public:
  PeakSearch(EditableSurface& surface, const ReferenceSurface& reference,
    const std::vector<Vec3>& samples, const PeakFitOptions& options, const Execution& execution)
    : Surface(surface)
    , Reference(reference)
    , Samples(samples)
    , Options(options)
    , SamplesOfFace(at(surface.faceSlots()))
  {
    SampleDistances distances(surface, samples, execution);
    this->FaceOfSample = std::move(distances.face);
    this->Distance = std::move(distances.distance);
    this->sortByFace();
  }

  /// Measures anew; no sample's closest face is far from what it was.
  void update()
  {
    for (std::size_t s = 0; s < this->Samples.size(); ++s)
    {
      double nearest = std::numeric_limits<double>::infinity();
      Index closest = NoIndex;
      for (const Index f : this->facesAround(this->FaceOfSample[s]))
      {
        const double squared =
          closestPointOnTriangle(this->Samples[s], triangleOf(this->Surface, f)).squaredDistance;
        if (squared < nearest)
        {
          nearest = squared;
          closest = f;
        }
      }
      this->FaceOfSample[s] = closest;
      this->Distance[s] = std::sqrt(nearest);
    }
    this->sortByFace();
  }

  Index run()
  {
    std::vector<std::pair<double, std::size_t>> far;
    for (std::size_t s = 0; s < this->Samples.size(); ++s)
    {
      const Index f = this->FaceOfSample[s];
      if (f == NoIndex)
      {
        continue;
      }
      const double size = this->Surface.size(this->Surface.from(3 * f));
      if (this->Distance[s] > this->Options.tolerance * size &&
        this->Distance[s] < this->farthestFor(s) * size)
      {
        far.emplace_back(-this->Distance[s], s);
      }
    }
    std::sort(far.begin(), far.end());
    Index moved = 0;
    std::vector<char> isDone(at(this->Surface.faceSlots()), 0);
    for (const auto& [distance, s] : far)
    {
      // One move per neighbourhood and round: the other samples' distances are out of date.
      const std::vector<Index> faces = this->facesAround(this->FaceOfSample[s]);
      const bool isFresh =
        std::none_of(faces.begin(), faces.end(), [&](Index f) { return isDone[at(f)] != 0; });
      if (isFresh && this->approach(s, faces))
      {
        ++moved;
        for (const Index f : faces)
        {
          isDone[at(f)] = 1;
        }
      }
    }
    return moved;
  }

private:
  void sortByFace()
  {
    for (std::vector<std::size_t>& samples : this->SamplesOfFace)
    {
      samples.clear();
    }
    for (std::size_t s = 0; s < this->Samples.size(); ++s)
    {
      if (this->FaceOfSample[s] == NoIndex)
      {
        continue;
      }
      this->SamplesOfFace[at(this->FaceOfSample[s])].push_back(s);
    }
  }

  /// The faces that share a vertex with a face, in ascending order.
  std::vector<Index> facesAround(Index f) const
  {
    std::vector<Index> faces;
    for (Index k = 0; k < 3; ++k)
    {
      this->Surface.forEachOutgoing(this->Surface.from(3 * f + k),
        [&](Index e) { faces.push_back(EditableSurface::faceOf(e)); });
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  /// Peaks are outside, valleys inside.
  double farthestFor(std::size_t s) const
  {
    const Index f = this->FaceOfSample[s];
    const bool isOutside =
      (this->Samples[s] - this->Surface.corner(f, 0)).dot(this->Surface.doubleArea(f)) > 0.0;
    return isOutside ? this->Options.farthest : this->Options.deepest;
  }

  bool approach(std::size_t s, const std::vector<Index>& faces)
  {
    const Index f = this->FaceOfSample[s];
    const Triangle triangle = triangleOf(this->Surface, f);
    const Vec3& peak = this->Samples[s];
    const Vec3 foot = closestPointOnTriangle(peak, triangle).point;
    Vec3 share = barycentricCoordinates(triangle, foot);
    std::array<Vec3, 3> before;
    for (Index k = 0; k < 3; ++k)
    {
      const Index v = this->Surface.from(3 * f + k);
      before[at(k)] = this->Surface.point(v);
      const bool isFree = !this->Surface.isPinned(v) && this->Surface.featureEdges(v) == 0;
      share[k] = isFree ? std::max(0.0, share[k]) : 0.0;
    }
    if (share.squaredNorm() < 0.1)
    {
      return false;
    }
    share /= share.squaredNorm();
    const std::vector<Vec3> areas = this->areasOf(faces);
    const double leastAngle = std::min(this->Options.leastAngle, this->smallestAngle(faces));
    double best = LeastGain * this->largestDistance(faces);
    double bestFraction = 0.0;
    const auto moveBy = [&](double fraction)
    {
      for (Index k = 0; k < 3; ++k)
      {
        this->Surface.setPoint(
          this->Surface.from(3 * f + k), before[at(k)] + fraction * share[k] * (peak - foot));
      }
    };
    for (const double fraction : Fractions)
    {
      moveBy(fraction);
      if (this->smallestAngle(faces) >= leastAngle && this->areUpright(faces, areas))
      {
        const double distance = this->largestDistance(faces);
        if (distance < best)
        {
          best = distance;
          bestFraction = fraction;
        }
      }
    }
    moveBy(bestFraction);
    return bestFraction > 0.0;
  }

  std::vector<Vec3> areasOf(const std::vector<Index>& faces) const
  {
    std::vector<Vec3> areas;
    for (const Index f : faces)
    {
      areas.push_back(this->Surface.doubleArea(f));
    }
    return areas;
  }

  bool areUpright(const std::vector<Index>& faces, const std::vector<Vec3>& before) const
  {
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      const Vec3 area = this->Surface.doubleArea(faces[i]);
      if (area.dot(before[i]) < LeastCosine * area.norm() * before[i].norm())
      {
        return false;
      }
    }
    return true;
  }

  double smallestAngle(const std::vector<Index>& faces) const
  {
    double cosine = 0.5;
    for (const Index f : faces)
    {
      cosine = std::max(cosine,
        cosineOfSmallestAngle(
          this->Surface.corner(f, 0), this->Surface.corner(f, 1), this->Surface.corner(f, 2)));
    }
    return std::acos(std::min(1.0, cosine)) * 180.0 / Pi;
  }

  /// Both ways, between the faces and the target's samples and surface around them.
  double largestDistance(const std::vector<Index>& faces) const
  {
    double largest = 0.0;
    for (const Index f : faces)
    {
      for (const std::size_t s : this->SamplesOfFace[at(f)])
      {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Index g : faces)
        {
          nearest = std::min(nearest,
            closestPointOnTriangle(this->Samples[s], triangleOf(this->Surface, g)).squaredDistance);
        }
        largest = std::max(largest, nearest);
      }
      largest = std::max(largest, this->squaredDistanceToReference(f));
    }
    return std::sqrt(largest);
  }

  double squaredDistanceToReference(Index f) const
  {
    const Vec3 facing = this->Surface.doubleArea(f).stableNormalized();
    double largest = 0.0;
    Index guess = this->Surface.guess(this->Surface.from(3 * f));
    const auto measure = [&](const Vec3& point)
    {
      const auto foot = this->Reference.onSurface(point, facing, this->Surface.label(f), guess);
      guess = foot.triangle;
      largest = std::max(largest, (foot.point - point).squaredNorm());
    };
    for (const std::array<double, 3>& b : FitPlaces)
    {
      measure(b[0] * this->Surface.corner(f, 0) + b[1] * this->Surface.corner(f, 1) +
        b[2] * this->Surface.corner(f, 2));
    }
    for (Index k = 0; k < 3; ++k)
    {
      measure(this->Surface.corner(f, k));
    }
    return largest;
  }

  EditableSurface& Surface;
  const ReferenceSurface& Reference;
  const std::vector<Vec3>& Samples;
  const PeakFitOptions& Options;
  std::vector<Index> FaceOfSample;
  std::vector<double> Distance;
  std::vector<std::vector<std::size_t>> SamplesOfFace;
};

} // namespace

std::vector<Vec3> samplesBeyond(const EditableSurface& surface, const std::vector<Vec3>& samples,
  double tolerance, const Execution& execution)
{
  const SampleDistances distances(surface, samples, execution);
  std::vector<Vec3> beyond;
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    const Index f = distances.face[s];
    if (f == NoIndex || distances.distance[s] > tolerance * surface.size(surface.from(3 * f)))
    {
      beyond.push_back(samples[s]);
    }
  }
  return beyond;
}

Index fitPeaks(EditableSurface& surface, const ReferenceSurface& reference,
  const std::vector<Vec3>& samples, const PeakFitOptions& options, const Execution& execution)
{
  PeakSearch search(surface, reference, samples, options, execution);
  Index moved = 0;
  for (int round = 0; round < options.rounds; ++round)
  {
    const Index now = search.run();
    moved += now;
    if (now == 0)
    {
      break;
    }
    search.update();
  }
  return moved;
}

} // namespace evolving
