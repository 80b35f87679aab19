// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/StageGuard.h"

#include "Distance/AABBTree.h"
#include "Mesh/SelfIntersections.h"
#include "ParallelLoops.h"
#include "Remeshing/Untangling.h"

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

/// The intersecting triangles alone.
SurfaceMesh facesOf(const SurfaceMesh& mesh, const FacePairs& pairs)
{
  std::vector<char> isIn(at(mesh.faceCount()), 0);
  for (const auto& [first, second] : pairs)
  {
    isIn[at(first)] = 1;
    isIn[at(second)] = 1;
  }
  SurfaceMesh faces;
  faces.points = mesh.points;
  for (Index f = 0; f < mesh.faceCount(); ++f)
  {
    if (isIn[at(f)] != 0)
    {
      faces.addFace({ mesh.faceVertex(f, 0), mesh.faceVertex(f, 1), mesh.faceVertex(f, 2) });
    }
  }
  return faces;
}

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

Index runGuarded(EditableSurface& surface, const RemeshingStage& stage, const Execution& execution)
{
  EditableSurface before = surface;
  Index made = 0;
  for (int run = 1; run <= MostRuns; ++run)
  {
    stage(surface);
    surface.compact();
    const SurfaceMesh mesh = surface.mesh();
    const FacePairs pairs = selfIntersections(mesh, execution.phase(0.0, 0.0));
    if (run == 1)
    {
      made = static_cast<Index>(pairs.size());
    }
    if (pairs.empty() || untangle(surface, pairs, execution))
    {
      surface.releaseLocks();
      return made;
    }
    lockAround(before, facesOf(mesh, pairs), run * LockedSizes);
    surface = before;
  }
  surface.releaseLocks();
  return made;
}

Index runMoves(EditableSurface& surface, const RemeshingStage& stage, const Execution& execution)
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
