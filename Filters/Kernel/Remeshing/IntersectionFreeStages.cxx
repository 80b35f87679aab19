// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/IntersectionFreeStages.h"

#include "Mesh/SelfIntersections.h"
#include "ParallelLoops.h"
#include "Remeshing/FaceShape.h"
#include "Remeshing/Untangling.h"
#include "Remeshing/VerticesNear.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace evolving
{

namespace
{

/// A stage is run so often at most before it is left out.
constexpr int MostRuns = 5;
/// How far around an intersection the surface is locked, in sizes, after each run.
constexpr double LockedSizes = 2.0;

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

  std::ptrdiff_t count() const { return std::count(this->IsFault.begin(), this->IsFault.end(), 1); }

  /// A corner of the first one.
  Vec3 place() const
  {
    const auto first = std::find(this->IsFault.begin(), this->IsFault.end(), 1);
    return this->Surface.corner(static_cast<Index>(first - this->IsFault.begin()), 0);
  }

  SurfaceMesh faces() const
  {
    SurfaceMesh faces;
    faces.points = this->Surface.triangles().points();
    for (Index f = 0; f < this->Surface.faceSlots(); ++f)
    {
      if (this->IsFault[at(f)] != 0)
      {
        faces.addFace({ this->Surface.from(3 * f), this->Surface.from(3 * f + 1),
          this->Surface.from(3 * f + 2) });
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
  const std::vector<char> isNear = verticesNear(surface, faces, sizes);
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (isNear[at(v)] != 0)
    {
      surface.setLocked(v);
    }
  }
}

bool isAllLocked(const EditableSurface& surface)
{
  bool isAll = true;
  for (Index v = 0; isAll && v < surface.vertexSlots(); ++v)
  {
    isAll = !surface.hasVertex(v) || surface.isLocked(v);
  }
  return isAll;
}

/**
 * Takes the vertices of intersecting triangles back until none is left, or they intersected before.
 * @param takeBack changes what the view sees
 * @return the number of vertices taken back
 */
template <class TakeBack>
Index takeIntersectionsBack(
  const TriangleView& triangles, const TakeBack& takeBack, const Execution& execution)
{
  std::vector<char> isBack(triangles.points().size(), 0);
  Index count = 0;
  for (Index countBefore = NoIndex; count != countBefore;)
  {
    countBefore = count;
    for (const auto& [first, second] : selfIntersections(triangles, execution.phase(0.0, 0.0)))
    {
      for (const Index face : { first, second })
      {
        for (const Index v : triangles.vertices(face))
        {
          count += isBack[at(v)] == 0 ? 1 : 0;
          isBack[at(v)] = 1;
          takeBack(v);
        }
      }
    }
  }
  return count;
}

} // namespace

StageRuns runWithoutIntersections(EditableSurface& surface, const RemeshingStage& stage,
  const Execution& execution, double leastAngle)
{
  EditableSurface before = surface;
  StageRuns runs;
  std::ptrdiff_t faultsAtFirst = 0;
  for (int run = 1; run <= MostRuns; ++run)
  {
    stage(surface);
    surface.compact();
    FacePairs pairs = selfIntersections(surface.triangles(), execution.phase(0.0, 0.0));
    runs.intersections = run == 1 ? static_cast<Index>(pairs.size()) : runs.intersections;
    pairs = untangle(surface, std::move(pairs), execution);
    Faults faults(surface);
    faults.add(pairs);
    if (leastAngle > 0.0)
    {
      faults.addAngles(leastAngle);
    }
    if (faults.count() == 0)
    {
      runs.isLeftOut = isAllLocked(surface);
      surface.releaseLocks();
      return runs;
    }
    faultsAtFirst = run == 1 ? faults.count() : faultsAtFirst;
    runs.place = faults.place();
    const bool isInVain = run > 1 && pairs.empty() && faults.count() >= faultsAtFirst;
    lockAround(before, faults.faces(), run * LockedSizes);
    surface = before;
    if (isInVain)
    {
      break;
    }
  }
  surface.releaseLocks();
  runs.isLeftOut = true;
  return runs;
}

Index moveWithoutIntersections(
  EditableSurface& surface, const RemeshingStage& stage, const Execution& execution)
{
  surface.compact();
  const std::vector<Vec3> before = surface.triangles().points();
  stage(surface);
  return takeIntersectionsBack(
    surface.triangles(), [&](Index v) { surface.setPoint(v, before[at(v)]); }, execution);
}

Index undoIntersections(
  SurfaceMesh& mesh, const std::vector<Vec3>& before, const Execution& execution)
{
  return takeIntersectionsBack(
    triangleView(mesh), [&](Index v) { mesh.points[at(v)] = before[at(v)]; }, execution);
}

} // namespace evolving
