// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/ElementRepair.h"

#include "ParallelLoops.h"
#include "Remeshing/EdgeCollapsing.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/StarOptimization.h"
#include "Remeshing/SurfacePatch.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// A try must raise the smallest angle by so much, in degrees: less is not worth other elements,
/// and tries could follow each other without end.
constexpr double LeastGain = 0.3;
/// Stars are improved up to this angle, and for so many rounds, after each try, as at the end of a
/// wrap (FinishTuning::wantedAngle), whose fewer stars need fewer rounds.
constexpr double WantedAngle = 46.0;
constexpr int StarRounds = 3;
/// More bad triangles than this are no place to repair but a surface to remesh.
constexpr std::size_t MostFaces = 300;
/// So many rings of vertices around a bad triangle make room for it.
constexpr int Rings = 2;

/// The vertices within some rings of a few, in ascending order.
std::vector<Index> ringsAround(
  const EditableSurface& surface, std::vector<Index> vertices, int rings)
{
  for (int ring = 0; ring < rings; ++ring)
  {
    std::vector<Index> more = vertices;
    for (const Index v : vertices)
    {
      surface.forEachNeighbour(v, [&more](Index u) { more.push_back(u); });
    }
    std::sort(more.begin(), more.end());
    more.erase(std::unique(more.begin(), more.end()), more.end());
    vertices = std::move(more);
  }
  return vertices;
}

double smallestAngleAt(const EditableSurface& surface, const std::vector<Index>& vertices)
{
  double smallest = 60.0;
  for (const Index v : vertices)
  {
    surface.forEachOutgoing(v,
      [&](Index e)
      { smallest = std::min(smallest, smallestAngle(surface, EditableSurface::faceOf(e))); });
  }
  return smallest;
}

/// The faces with an angle below a limit, the worst first.
std::vector<std::pair<double, Index>> badFaces(const EditableSurface& surface, double degrees)
{
  std::vector<std::pair<double, Index>> faces;
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    if (surface.hasFace(f))
    {
      const double angle = smallestAngle(surface, f);
      if (angle < degrees)
      {
        faces.emplace_back(angle, f);
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

class Repair
{
public:
  Repair(EditableSurface& surface, const ReferenceSurface& reference)
    : Surface(surface)
    , Reference(reference)
  {
  }

  /// @return whether the place of the face is better now
  bool run(Index face)
  {
    this->Corners = { this->Surface.from(3 * face), this->Surface.from(3 * face + 1),
      this->Surface.from(3 * face + 2) };
    // Operations change the connectivity within the first ring, and stars move in the second.
    const std::vector<Index> around = ringsAround(this->Surface, this->Corners, Rings);
    const SurfacePatch before(this->Surface, around);
    double bestAngle = smallestAngleAt(this->Surface, around) + LeastGain;
    std::function<bool()> best;
    for (const std::function<bool()>& operation : this->operationsOn(face))
    {
      const double angle = operation() ? this->improvedAngle() : 0.0;
      if (angle > bestAngle)
      {
        bestAngle = angle;
        best = operation;
      }
      before.restore(this->Surface);
    }
    if (best)
    {
      best();
      this->improvedAngle();
    }
    return static_cast<bool>(best);
  }

private:
  /// Each says whether it was possible.
  std::vector<std::function<bool()>> operationsOn(Index face)
  {
    std::vector<std::function<bool()>> operations;
    for (Index k = 0; k < 3; ++k)
    {
      const Index e = 3 * face + k;
      operations.emplace_back([this, e] { return this->flip(e); });
      operations.emplace_back([this, e] { return this->collapse(e); });
    }
    operations.emplace_back([this, face] { return this->splitLongest(face); });
    return operations;
  }

  bool flip(Index e)
  {
    if (!this->Surface.canFlip(e))
    {
      return false;
    }
    this->Surface.flip(e);
    return true;
  }

  bool collapse(Index e)
  {
    CollapseLimits guards;
    guards.leastQuality = 0.0;
    return collapseEdge(this->Surface, e, guards);
  }

  bool splitLongest(Index face)
  {
    Index longest = 3 * face;
    for (Index k = 1; k < 3; ++k)
    {
      longest =
        this->Surface.length(3 * face + k) > this->Surface.length(longest) ? 3 * face + k : longest;
    }
    if (this->Surface.isFeature(longest) || this->Surface.isLockedFace(face))
    {
      return false;
    }
    const Vec3 middle = 0.5 *
      (this->Surface.point(this->Surface.from(longest)) +
        this->Surface.point(this->Surface.to(longest)));
    this->Surface.split(longest, middle);
    return true;
  }

  /// The smallest angle around, after the stars there have been improved.
  double improvedAngle()
  {
    std::vector<Index> left;
    for (const Index v : this->Corners)
    {
      if (this->Surface.hasVertex(v))
      {
        left.push_back(v);
      }
    }
    if (left.empty())
    {
      return 0.0;
    }
    const std::vector<Index> around = ringsAround(this->Surface, left, Rings);
    optimizeStarsOf(this->Surface, this->Reference, around, WantedAngle, StarRounds);
    return smallestAngleAt(this->Surface, around);
  }

  EditableSurface& Surface;
  const ReferenceSurface& Reference;
  std::vector<Index> Corners;
};

} // namespace

Index repairElements(EditableSurface& surface, const ReferenceSurface& reference, double degrees,
  const Execution& execution)
{
  surface.compact();
  const auto faces = badFaces(surface, degrees);
  Index repaired = 0;
  if (faces.size() > MostFaces)
  {
    return 0;
  }
  for (const auto& [angle, face] : faces)
  {
    execution.report(0.0);
    // An earlier repair may have been enough, or have taken the face away.
    if (surface.hasFace(face) && smallestAngle(surface, face) < degrees &&
      Repair(surface, reference).run(face))
    {
      ++repaired;
    }
  }
  surface.compact();
  return repaired;
}

} // namespace evolving
