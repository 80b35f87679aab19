// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EdgeFlipping.h"

#include "ParallelLoops.h"
#include "Remeshing/FaceShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace evolving
{

namespace
{

/// Every flip lowers what is minimized, so sweeps end on their own; the later ones find nearly
/// nothing.
constexpr int MostSweeps = 8;
/// Of the angle between the faces' normals, before or after: 37 degrees, below the folds that are
/// creases by default.
constexpr double LeastFoldCosine = 0.8;

/// The two faces of an edge as they are and as they would be after a flip.
class FlipPair
{
public:
  FlipPair(const EditableSurface& surface, Index e)
    : A(surface.point(surface.from(e)))
    , B(surface.point(surface.to(e)))
    , C(surface.point(surface.apex(e)))
    , D(surface.point(surface.apex(surface.opposite(e))))
  {
  }

  /// Is the pair, bent as it is, not bent further, and its new faces not turned over?
  bool staysFlat() const
  {
    const double before = cosine(area(this->A, this->B, this->C), area(this->B, this->A, this->D));
    const Vec3 first = area(this->D, this->B, this->C);
    const Vec3 second = area(this->C, this->A, this->D);
    const Vec3 mean = area(this->A, this->B, this->C) + area(this->B, this->A, this->D);
    return cosine(first, second) >= std::min(LeastFoldCosine, before) &&
      cosine(first, mean) > 0.5 && cosine(second, mean) > 0.5 && before > 0.0;
  }
  double cosineBefore() const
  {
    return std::max(cosineOfSmallestAngle(this->A, this->B, this->C),
      cosineOfSmallestAngle(this->B, this->A, this->D));
  }
  double cosineAfter() const
  {
    return std::max(cosineOfSmallestAngle(this->D, this->B, this->C),
      cosineOfSmallestAngle(this->C, this->A, this->D));
  }

private:
  static Vec3 area(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }
  static double cosine(const Vec3& u, const Vec3& v)
  {
    const double norms = u.norm() * v.norm();
    return norms > 0.0 ? u.dot(v) / norms : -1.0;
  }

  Vec3 A, B, C, D;
};

/// Flips all edges that want to and can, calling announce(edge) before each, until none does.
template <class Wants, class Announce>
Index flipWhere(EditableSurface& surface, const Wants& wants, const Announce& announce)
{
  Index flips = 0;
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    Index done = 0;
    for (Index e = 0; e < surface.edgeSlots(); ++e)
    {
      if (surface.hasEdge(e) && surface.isFirstHalf(e) && !surface.isFeature(e) && wants(e) &&
        surface.canFlip(e))
      {
        announce(e);
        surface.flip(e);
        ++done;
      }
    }
    flips += done;
    if (done == 0)
    {
      break;
    }
  }
  return flips;
}

/// By how much the valences of all vertices exceed the best ones, kept up to date.
class ExcessValences
{
public:
  explicit ExcessValences(const EditableSurface& surface)
    : Surface(surface)
    , Excess(at(surface.vertexSlots()), 0)
  {
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      if (surface.hasVertex(v))
      {
        this->Excess[at(v)] = surface.valence(v) - (surface.isBoundary(v) ? 4 : 6);
      }
    }
  }

  /// By how much the sum of their squares falls when an edge flips.
  Index gain(Index e) const
  {
    const auto [a, b, c, d] = this->around(e);
    const auto change = [this](Index v, Index by)
    {
      const Index before = this->Excess[at(v)];
      return (before + by) * (before + by) - before * before;
    };
    return -(change(a, -1) + change(b, -1) + change(c, 1) + change(d, 1));
  }

  /// Before the flip of an edge.
  void flip(Index e)
  {
    const auto [a, b, c, d] = this->around(e);
    this->Excess[at(a)] -= 1;
    this->Excess[at(b)] -= 1;
    this->Excess[at(c)] += 1;
    this->Excess[at(d)] += 1;
  }

private:
  /// The ends of an edge and the apexes of its faces.
  std::array<Index, 4> around(Index e) const
  {
    return { this->Surface.from(e), this->Surface.to(e), this->Surface.apex(e),
      this->Surface.apex(this->Surface.opposite(e)) };
  }

  const EditableSurface& Surface;
  std::vector<Index> Excess;
};

} // namespace

Index flipForValences(EditableSurface& surface)
{
  ExcessValences excess(surface);
  return flipWhere(
    surface,
    [&](Index e)
    {
      if (excess.gain(e) <= 0)
      {
        return false;
      }
      const FlipPair pair(surface, e);
      const double before = std::acos(std::min(1.0, pair.cosineBefore()));
      const double after = std::acos(std::min(1.0, pair.cosineAfter()));
      return after > 0.5 * before && pair.staysFlat();
    },
    [&excess](Index e) { excess.flip(e); });
}

Index flipForAngles(EditableSurface& surface)
{
  return flipWhere(
    surface,
    [&surface](Index e)
    {
      const FlipPair pair(surface, e);
      return pair.cosineAfter() < pair.cosineBefore() - 1e-9 && pair.staysFlat();
    },
    [](Index) {});
}

} // namespace evolving
