// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EdgeFlipping.h"

#include "Remeshing/FaceShape.h"

#include <algorithm>
#include <cmath>

namespace evolving
{

namespace
{

constexpr int MostSweeps = 8;
/// Of the angle between the faces' normals, before or after.
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

/// Calls flipsIf(edge) for all edges that could flip, until it flips none.
template <class Wants>
Index flipWhere(EditableSurface& surface, const Wants& wants)
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

/// By how much the squared deviations from the best valences fall when an edge flips.
Index valenceGain(const EditableSurface& surface, Index e)
{
  const auto deviation = [&surface](Index v, Index change)
  {
    const Index d = surface.valence(v) + change - (surface.isBoundary(v) ? 4 : 6);
    return d * d;
  };
  const Index a = surface.from(e);
  const Index b = surface.to(e);
  const Index c = surface.apex(e);
  const Index d = surface.apex(surface.opposite(e));
  return deviation(a, 0) + deviation(b, 0) + deviation(c, 0) + deviation(d, 0) - deviation(a, -1) -
    deviation(b, -1) - deviation(c, 1) - deviation(d, 1);
}

} // namespace

Index flipForValences(EditableSurface& surface)
{
  return flipWhere(surface,
    [&surface](Index e)
    {
      if (valenceGain(surface, e) <= 0)
      {
        return false;
      }
      const FlipPair pair(surface, e);
      const double before = std::acos(std::min(1.0, pair.cosineBefore()));
      const double after = std::acos(std::min(1.0, pair.cosineAfter()));
      return after > 0.5 * before && pair.staysFlat();
    });
}

Index flipForAngles(EditableSurface& surface)
{
  return flipWhere(surface,
    [&surface](Index e)
    {
      const FlipPair pair(surface, e);
      return pair.cosineAfter() < pair.cosineBefore() - 1e-9 && pair.staysFlat();
    });
}

} // namespace evolving
