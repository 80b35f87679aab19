// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/IntersectionFreeStages.h"

#include "Mesh/SelfIntersections.h"
#include "ParallelLoops.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/Untangling.h"
#include "Trees/AABBTree.h"

#include <algorithm>
#include <utility>

namespace evolving
{

namespace
{

/// A stage is run so often at most before it is left out.
constexpr int MostRuns = 5;
/// How far around an intersection the surface is locked, in sizes, after each run.
constexpr double LockedSizes = 2.0;

using FacePairs = std::vector<std::pair<Index, Index>>;

/// Where a stage has failed.
class Faults
{
public:
  explicit Faults(const EditableSurface& surface)
    : Surface(surface)
    , IsFault(at(surface.faceSlots()), 0)
  {
  }

  void add(const FacePairs& pairs)
  {
    for (const auto& [first, second] : pairs)
    {
      this->IsFault[at(first)] = 1;
      this->IsFault[at(second)] = 1;
    }
  }

  /// What is locked has not been changed, and one or two can be repaired.
  void addAngles(double leastAngle)
  {
    constexpr std::size_t Few = 2;
    std::vector<Index> small;
    for (Index f = 0; f < this->Surface.faceSlots(); ++f)
    {
      const bool isSmall = smallestAngle(this->Surface, f) < leastAngle;
      if (isSmall && !this->Surface.isLockedFace(f))
      {
        small.push_back(f);
      }
    }
    for (std::size_t i = 0; small.size() > Few && i < small.size(); ++i)
    {
      this->IsFault[at(small[i])] = 1;
    }
  }

  bool areNone() const
  {
    return std::none_of(
      this->IsFault.begin(), this->IsFault.end(), [](char isFault) { return isFault != 0; });
  }

  SurfaceMesh faces() const
  {
    SurfaceMesh faces;
    const SurfaceMesh all = this->Surface.mesh();
    faces.points = all.points;
    for (Index f = 0; f < all.faceCount(); ++f)
    {
      if (this->IsFault[at(f)] != 0)
      {
        faces.addFace({ all.faceVertex(f, 0), all.faceVertex(f, 1), all.faceVertex(f, 2) });
      }
    }
    return faces;
  }

private:
  const EditableSurface& Surface; ///< compact
  std::vector<char> IsFault;
};

void lockAround(EditableSurface& surface, const SurfaceMesh& faces, double sizes)
{
  const AABBTree tree(faces);
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v))
    {
      const double reach = sizes * surface.size(v);
      if (tree.closest(surface.point(v), reach * reach).triangle != NoIndex)
      {
        surface.setLocked(v);
      }
    }
  }
}

} // namespace

Index runWithoutIntersections(EditableSurface& surface, const RemeshingStage& stage,
  const Execution& execution, double leastAngle)
{
  EditableSurface before = surface;
  Index made = 0;
  for (int run = 1; run <= MostRuns; ++run)
  {
    stage(surface);
    surface.compact();
    const FacePairs pairs = selfIntersections(surface.mesh(), execution.phase(0.0, 0.0));
    made = run == 1 ? static_cast<Index>(pairs.size()) : made;
    Faults faults(surface);
    if (!pairs.empty() && !untangle(surface, pairs, execution))
    {
      faults.add(pairs);
    }
    if (leastAngle > 0.0)
    {
      faults.addAngles(leastAngle);
    }
    if (faults.areNone())
    {
      surface.releaseLocks();
      return made;
    }
    lockAround(before, faults.faces(), run * LockedSizes);
    surface = before;
  }
  surface.releaseLocks();
  return made;
}

Index moveWithoutIntersections(
  EditableSurface& surface, const RemeshingStage& stage, const Execution& execution)
{
  surface.compact();
  const std::vector<Vec3> before = surface.mesh().points;
  stage(surface);
  SurfaceMesh mesh = surface.mesh();
  const Index count = undoIntersections(mesh, before, execution);
  for (Index v = 0; count > 0 && v < surface.vertexSlots(); ++v)
  {
    surface.setPoint(v, mesh.points[at(v)]);
  }
  return count;
}

Index undoIntersections(
  SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution)
{
  std::vector<char> isBack(mesh.points.size(), 0);
  Index count = 0;
  const auto takeBack = [&](Index face)
  {
    for (Index k = 0; k < 3; ++k)
    {
      const Index v = mesh.faceVertex(face, k);
      count += isBack[at(v)] == 0 ? 1 : 0;
      isBack[at(v)] = 1;
      mesh.points[at(v)] = before[at(v)];
    }
  };
  for (;;)
  {
    const FacePairs pairs = selfIntersections(mesh, execution.phase(0.0, 0.0));
    if (pairs.empty())
    {
      return count;
    }
    const Index countBefore = count;
    for (const auto& [first, second] : pairs)
    {
      takeBack(first);
      takeBack(second);
    }
    if (count == countBefore)
    {
      return count; // they intersected before
    }
  }
}

} // namespace evolving
