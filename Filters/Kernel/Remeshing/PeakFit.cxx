// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/PeakFit.h"

#include "ParallelLoops.h"
#include "Remeshing/FaceGroup.h"
#include "Remeshing/OrderedTasks.h"
#include "Remeshing/SurfaceFit.h"
#include "Trees/Barycentric.h"
#include "Trees/TriangleGeometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace evolving
{

namespace
{

/// Fractions of the way to a peak that are tried.
constexpr std::array<double, 4> Fractions = { 1.0, 0.7, 0.45, 0.25 };
/// The larger distance must fall to this fraction.
constexpr double LeastGain = 0.97;
/// Where so many samples have been tried in vain the others wait for the next run.
constexpr int MostTries = 2;
/// Peaks that are worth a thread.
constexpr std::int64_t PeakGrain = 4;
constexpr double Unbounded = std::numeric_limits<double>::infinity();

/// A point of a face is to make a move: the part of it that each corner makes for that. Pinned
/// corners and those on features stay; zero where the point is too far from the others.
Vec3 sharesOf(const EditableSurface& surface, Index f, const Vec3& point)
{
  Vec3 share = barycentricCoordinates(triangleOf(surface, f), point);
  for (Index k = 0; k < 3; ++k)
  {
    const Index v = surface.from(3 * f + k);
    const bool isFree = !surface.isPinned(v) && surface.featureEdges(v) == 0;
    share[k] = isFree ? std::max(0.0, share[k]) : 0.0;
  }
  constexpr double LeastSay = 0.1;
  return share.squaredNorm() < LeastSay ? Vec3(Vec3::Zero()) : Vec3(share / share.squaredNorm());
}

} // namespace

PeakFit::PeakFit(EditableSurface& surface, const ReferenceSurface& reference,
  const std::vector<Vec3>& samples, double nearest, const Execution& execution)
  : Surface(surface)
  , Reference(reference)
  , Run(execution)
  , Distances(surface, samples, nearest, execution)
  , InVain(this->Distances.count(), 0)
{
}

Index PeakFit::run(const PeakFitOptions& options)
{
  Index moved = 0;
  for (int round = 0; round < options.rounds; ++round)
  {
    this->Distances.update();
    const Index now = this->runOnce(options);
    moved += now;
    if (now == 0)
    {
      break;
    }
  }
  return moved;
}

/// The farthest first.
std::vector<std::size_t> PeakFit::peaks(const PeakFitOptions& options) const
{
  std::vector<std::pair<double, std::size_t>> byDistance;
  for (std::size_t s = 0; s < this->Distances.count(); ++s)
  {
    if (this->isPeak(s, options))
    {
      byDistance.emplace_back(-this->Distances.distance(s), s);
    }
  }
  std::sort(byDistance.begin(), byDistance.end());
  std::vector<std::size_t> peaks;
  for (const auto& [distance, s] : byDistance)
  {
    peaks.push_back(s);
  }
  return peaks;
}

/// One move per neighbourhood: the other samples' distances are out of date.
Index PeakFit::runOnce(const PeakFitOptions& options)
{
  const std::vector<std::size_t> peaks = this->peaks(options);
  std::vector<char> isDone(at(this->Surface.faceSlots()), 0);
  std::vector<int> tries(at(this->Surface.faceSlots()), 0);
  std::vector<char> hasMoved(peaks.size(), 0);
  const auto tryPeak = [&](std::size_t i)
  {
    const std::size_t s = peaks[i];
    const Index face = this->Distances.face(s);
    if (tries[at(face)]++ >= MostTries)
    {
      return;
    }
    const std::vector<Index> faces = this->Distances.facesAround(face);
    const bool isFresh =
      std::none_of(faces.begin(), faces.end(), [&](Index f) { return isDone[at(f)] != 0; });
    const std::size_t print = fingerprintOf(this->Surface, faces);
    if (!isFresh || this->InVain[s] == print)
    {
      return;
    }
    this->InVain[s] = print;
    if (this->approach(s, faces, options.leastAngle))
    {
      hasMoved[i] = 1;
      for (const Index f : faces)
      {
        isDone[at(f)] = 1;
      }
    }
  };
  runInOrder(
    peaks.size(),
    [&](std::size_t i) { return this->Distances.facesAround(this->Distances.face(peaks[i])); },
    this->Surface.faceSlots(), PeakGrain, tryPeak, this->Run);
  return static_cast<Index>(std::count(hasMoved.begin(), hasMoved.end(), 1));
}

bool PeakFit::isPeak(std::size_t s, const PeakFitOptions& options) const
{
  const Index f = this->Distances.face(s);
  const Vec3 way = this->Distances.sample(s) - this->Surface.corner(f, 0);
  const double farthest =
    way.dot(this->Surface.doubleArea(f)) > 0.0 ? options.farthest : options.deepest;
  const double distance = this->Distances.distance(s);
  return distance > options.tolerance * this->Surface.size(this->Surface.from(3 * f)) &&
    distance < farthest;
}

bool PeakFit::approach(std::size_t s, const std::vector<Index>& faces, double leastAngle)
{
  const Index f = this->Distances.face(s);
  const Triangle before = triangleOf(this->Surface, f);
  const Vec3 foot = closestPointOnTriangle(this->Distances.sample(s), before).point;
  const Vec3 way = this->Distances.sample(s) - foot;
  const Vec3 share = sharesOf(this->Surface, f, foot);
  if (share.isZero())
  {
    return false;
  }
  const auto moveBy = [&](double fraction)
  {
    for (Index k = 0; k < 3; ++k)
    {
      this->Surface.setPoint(
        this->Surface.from(3 * f + k), before.corners[at(k)] + fraction * share[k] * way);
    }
  };
  const std::vector<Vec3> areas = areasOf(this->Surface, faces);
  const double bound = std::min(leastAngle, smallestAngleOf(this->Surface, faces));
  double best = LeastGain * this->largestDistance(faces, Unbounded);
  double bestFraction = 0.0;
  for (const double fraction : Fractions)
  {
    moveBy(fraction);
    if (smallestAngleOf(this->Surface, faces) >= bound && areUpright(this->Surface, faces, areas))
    {
      const double distance = this->largestDistance(faces, best);
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

/// Both ways, between the faces and the target's samples and surface around them; or some distance
/// that is not below the bound.
double PeakFit::largestDistance(const std::vector<Index>& faces, double bound) const
{
  const double squaredBound = bound * bound;
  double largest = 0.0;
  for (const Index f : faces)
  {
    for (const std::size_t s : this->Distances.samplesAt(f))
    {
      if (largest >= squaredBound)
      {
        return std::sqrt(largest);
      }
      double nearest = Unbounded;
      for (const Index g : faces)
      {
        nearest = std::min(nearest,
          closestPointOnTriangle(this->Distances.sample(s), triangleOf(this->Surface, g))
            .squaredDistance);
      }
      largest = std::max(largest, nearest);
    }
  }
  for (const Index f : faces)
  {
    if (largest >= squaredBound)
    {
      break;
    }
    largest = std::max(largest, this->squaredDistanceToReference(f));
  }
  return std::sqrt(largest);
}

double PeakFit::squaredDistanceToReference(Index f) const
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

} // namespace evolving
