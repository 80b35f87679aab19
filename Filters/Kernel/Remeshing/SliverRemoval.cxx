// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SliverRemoval.h"

#include "Remeshing/EdgeCollapsing.h"
#include "Remeshing/EditableSurface.h"
#include "Remeshing/FaceShape.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace evolving
{

namespace
{

/// Triangles with a smaller angle, in degrees, are slivers: the ones of a regular contour have 30.
constexpr double SliverAngle = 20.0;
/// An edge that collapses is shorter, relative to those around: what is longer is no near
/// coincidence, and its triangle a matter of remeshing.
constexpr double ShortEdge = 0.5;
/// Relative to the edges around: by how much the surface and its boundary may move where a point
/// vanishes. A contour's own boundary is a hundredth from the curve it stands for; with half of
/// this, slivers are left at some.
constexpr double DeepestCut = 0.02;
/// Relative to the edges around: how long edges may become.
constexpr double LongestEdge = 2.0;
/// The cosine of 30 degrees: how far a vertex's faces may be from one plane for it to have a
/// normal.
constexpr double SmoothCosine = 0.87;
/// The cosine of 45 degrees: by how much a boundary turns at a corner.
constexpr double StraightCosine = 0.7;
/// Sweeps end when nothing changes; each takes the worst of what the one before has left.
constexpr int MostSweeps = 10;

/// The mean length of the edges within two rings of every vertex.
void setLocalSizes(EditableSurface& surface)
{
  std::vector<double> mean(at(surface.vertexSlots()));
  const auto average = [&surface](Index v, auto valueOf)
  {
    double sum = 0.0;
    Index count = 0;
    surface.forEachNeighbour(v,
      [&](Index u)
      {
        sum += valueOf(u);
        ++count;
      });
    return count > 0 ? sum / count : 0.0;
  };
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    mean[at(v)] = average(v, [&](Index u) { return (surface.point(u) - surface.point(v)).norm(); });
  }
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    surface.setSize(v, average(v, [&](Index u) { return mean[at(u)]; }));
  }
}

bool isSmoothAt(const EditableSurface& surface, Index v)
{
  Vec3 sum = Vec3::Zero();
  double total = 0.0;
  surface.forEachOutgoing(v,
    [&](Index e)
    {
      const Vec3 area = surface.doubleArea(EditableSurface::faceOf(e));
      sum += area;
      total += area.norm();
    });
  return sum.norm() >= SmoothCosine * total;
}

/// Points of a boundary that turns there stay.
void pinCorners(EditableSurface& surface)
{
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    Vec3 onwards = Vec3::Zero();
    Vec3 here = Vec3::Zero();
    surface.forEachOutgoing(v,
      [&](Index e)
      {
        if (surface.opposite(e) == NoIndex)
        {
          onwards = surface.point(surface.to(e)) - surface.point(v);
        }
        if (surface.opposite(EditableSurface::previous(e)) == NoIndex)
        {
          here = surface.point(v) - surface.point(surface.apex(e));
        }
      });
    if (onwards.dot(here) < StraightCosine * onwards.norm() * here.norm())
    {
      surface.setPinned(v);
    }
  }
}

class SliverRemoval
{
public:
  explicit SliverRemoval(const SurfaceMesh& mesh)
    : Surface(mesh)
  {
    this->Limits.longest = LongestEdge;
    this->Limits.deepestCut = DeepestCut;
    this->Limits.leastQuality = 0.0; // a sliver that a collapse leaves is the next to go
    setLocalSizes(this->Surface);
    pinCorners(this->Surface);
  }

  /// @return whether anything has changed
  bool run()
  {
    bool hasChanged = false;
    for (int sweep = 0; sweep < MostSweeps && !this->slivers().empty(); ++sweep)
    {
      const bool isChange = this->improveSlivers();
      hasChanged = hasChanged || isChange;
      if (!isChange)
      {
        break;
      }
    }
    return hasChanged;
  }

  SurfaceMesh mesh() const { return this->Surface.mesh(); }

private:
  bool isSliver(Index face) const
  {
    return this->Surface.hasFace(face) &&
      (smallestAngle(this->Surface, face) < SliverAngle || this->isSpeck(face));
  }

  /// Small as a whole, where slivers meet: well-shaped, but no triangle beside it can be.
  bool isSpeck(Index face) const
  {
    return this->isShort(3 * face) && this->isShort(3 * face + 1) && this->isShort(3 * face + 2);
  }

  /// The worst first.
  std::vector<std::pair<double, Index>> slivers() const
  {
    std::vector<std::pair<double, Index>> faces;
    for (Index f = 0; f < this->Surface.faceSlots(); ++f)
    {
      if (this->isSliver(f))
      {
        faces.emplace_back(smallestAngle(this->Surface, f), f);
      }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  bool improveSlivers()
  {
    bool hasChanged = false;
    for (const auto& [angle, face] : this->slivers())
    {
      if (this->isSliver(face)) // still
      {
        hasChanged = this->collapseAnEdge(face) || this->flipCap(face) || hasChanged;
      }
    }
    return hasChanged;
  }

  /// A cap lies in the face beyond its longest edge, as flat as that.
  bool flipCap(Index face)
  {
    const Index e = this->longestEdge(face);
    const double height = this->Surface.doubleArea(face).norm() / this->Surface.length(e);
    const Index o = this->Surface.opposite(e);
    if (o == NoIndex || !this->Surface.canFlip(e) ||
      height > DeepestCut * this->Surface.size(this->Surface.from(e), this->Surface.to(e)))
    {
      return false;
    }
    const Vec3& a = this->Surface.point(this->Surface.apex(e));
    const Vec3& b = this->Surface.point(this->Surface.apex(o));
    const auto angleAt = [&](Index v) { return smallestAngle(a, b, this->Surface.point(v)); };
    const double after = std::min(angleAt(this->Surface.from(e)), angleAt(this->Surface.to(e)));
    if (!(after > smallestAngle(this->Surface, face)))
    {
      return false;
    }
    this->Surface.flip(e);
    return true;
  }

  Index longestEdge(Index face) const
  {
    const std::array<Index, 3> edges = { 3 * face, 3 * face + 1, 3 * face + 2 };
    return *std::max_element(edges.begin(), edges.end(),
      [this](Index e, Index f) { return this->Surface.length(e) < this->Surface.length(f); });
  }

  /// The shortest edge that may.
  bool collapseAnEdge(Index face)
  {
    std::array<Index, 3> edges = { 3 * face, 3 * face + 1, 3 * face + 2 };
    std::sort(edges.begin(), edges.end(),
      [this](Index e, Index f) { return this->Surface.length(e) < this->Surface.length(f); });
    return std::any_of(edges.begin(), edges.end(),
      [this](Index e)
      {
        return this->isShort(e) && this->isSmooth(e) && this->isFlat(e) &&
          collapseEdge(this->Surface, e, this->Limits);
      });
  }

  bool isShort(Index e) const
  {
    const double size = this->Surface.size(this->Surface.from(e), this->Surface.to(e));
    return this->Surface.length(e) < ShortEdge * size;
  }

  bool isSmooth(Index e) const
  {
    const Index from = this->Surface.from(e);
    const Index to = this->Surface.to(e);
    return isSmoothAt(this->Surface, from) && isSmoothAt(this->Surface, to) &&
      this->Surface.normal(from).dot(this->Surface.normal(to)) >= SmoothCosine;
  }

  /// Over an edge between normals that differ by an angle a surface rises by about half the length
  /// times the angle: so much a collapse takes away. Of a boundary the limits say what may go.
  bool isFlat(Index e) const
  {
    const Index from = this->Surface.from(e);
    const Index to = this->Surface.to(e);
    const double turn = (this->Surface.normal(to) - this->Surface.normal(from)).norm();
    return this->Surface.opposite(e) == NoIndex ||
      0.5 * turn * this->Surface.length(e) <= DeepestCut * this->Surface.size(from, to);
  }

  EditableSurface Surface;
  CollapseLimits Limits;
};

} // namespace

std::optional<SurfaceMesh> withoutSlivers(const SurfaceMesh& surface)
{
  SliverRemoval removal(surface);
  return removal.run() ? std::optional<SurfaceMesh>(removal.mesh()) : std::nullopt;
}

} // namespace evolving
