// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * What must hold of an EditableSurface after any edit, and what kind of surface it is.
 */

#ifndef EVOLVING_EDITING_CHECKS_H
#define EVOLVING_EDITING_CHECKS_H

#include "Mesh/MeshTopology.h"
#include "Remeshing/EditableSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace evolving::editing
{

/// What no edit may change: Euler characteristic, boundary loops, components.
using Kind = std::array<Index, 3>;

/// @throws InputError when the mesh is no oriented manifold
inline Kind kindOf(const SurfaceMesh& mesh)
{
  const MeshTopology topology(mesh);
  return { summarizeTopology(mesh).eulerCharacteristic(),
    static_cast<Index>(topology.boundaryLoops().size()), topology.componentCount() };
}

/// The faces as sets of vertices do not repeat: MeshTopology takes two that lie on each other.
inline bool hasTwinFaces(const SurfaceMesh& mesh)
{
  std::set<std::array<Index, 3>> seen;
  for (Index f = 0; f < mesh.faceCount(); ++f)
  {
    std::array<Index, 3> face = { mesh.faceVertex(f, 0), mesh.faceVertex(f, 1),
      mesh.faceVertex(f, 2) };
    std::sort(face.begin(), face.end());
    if (!seen.insert(face).second)
    {
      return true;
    }
  }
  return false;
}

/// The half-edges point at each other, and each fan starts at the boundary if it has one.
inline void expectConsistent(const EditableSurface& surface)
{
  std::vector<Index> fan(static_cast<std::size_t>(surface.vertexSlots()), 0);
  std::vector<Index> seen(fan.size(), 0);
  for (Index e = 0; e < surface.edgeSlots(); ++e)
  {
    if (!surface.hasEdge(e))
    {
      continue;
    }
    ++fan[static_cast<std::size_t>(surface.from(e))];
    ASSERT_TRUE(surface.hasFace(EditableSurface::faceOf(e)));
    ASSERT_TRUE(surface.hasVertex(surface.from(e)));
    const Index o = surface.opposite(e);
    if (o != NoIndex)
    {
      ASSERT_EQ(surface.opposite(o), e);
      ASSERT_EQ(surface.from(o), surface.to(e));
      ASSERT_EQ(surface.to(o), surface.from(e));
      ASSERT_EQ(surface.curve(o), surface.curve(e));
      ASSERT_NE(surface.isFirstHalf(e), surface.isFirstHalf(o));
    }
  }
  for (Index v = 0; v < surface.vertexSlots(); ++v)
  {
    if (surface.hasVertex(v))
    {
      bool isFirst = true;
      bool touchesBoundary = false;
      surface.forEachOutgoing(v,
        [&](Index e)
        {
          ASSERT_EQ(surface.from(e), v);
          ASSERT_TRUE(isFirst || surface.opposite(e) != NoIndex) << "not first at the boundary";
          isFirst = false;
          touchesBoundary = touchesBoundary || surface.opposite(e) == NoIndex;
          ++seen[static_cast<std::size_t>(v)];
        });
      ASSERT_EQ(surface.isBoundary(v), touchesBoundary);
    }
  }
  ASSERT_EQ(seen, fan) << "a vertex does not see all its faces";
}

inline void expectSound(const EditableSurface& surface, const Kind& kind)
{
  expectConsistent(surface);
  const SurfaceMesh mesh = surface.mesh();
  ASSERT_NO_THROW(ASSERT_EQ(kindOf(mesh), kind));
  ASSERT_FALSE(hasTwinFaces(mesh));
}

/// The numbers below a count that are in use.
template <typename IsUsed>
std::vector<Index> usedOf(Index count, const IsUsed& isUsed)
{
  std::vector<Index> used;
  for (Index i = 0; i < count; ++i)
  {
    if (isUsed(i))
    {
      used.push_back(i);
    }
  }
  return used;
}

/// The live half-edges.
inline std::vector<Index> edgesOf(const EditableSurface& surface)
{
  return usedOf(surface.edgeSlots(), [&](Index e) { return surface.hasEdge(e); });
}

/// The live vertices.
inline std::vector<Index> verticesOf(const EditableSurface& surface)
{
  return usedOf(surface.vertexSlots(), [&](Index v) { return surface.hasVertex(v); });
}

/// The live faces.
inline std::vector<Index> facesOf(const EditableSurface& surface)
{
  return usedOf(surface.faceSlots(), [&](Index f) { return surface.hasFace(f); });
}

/// The half-edge between two vertices; NoIndex when there is none.
inline Index edgeBetween(const EditableSurface& surface, Index from, Index to)
{
  Index found = NoIndex;
  surface.forEachOutgoing(from, [&](Index e) { found = surface.to(e) == to ? e : found; });
  return found;
}

/// A point as something that sorts.
using Place = std::tuple<double, double, double>;
inline Place placeOf(const Vec3& p)
{
  return { p.x(), p.y(), p.z() };
}

/// All there is to know of a surface, whatever the numbers of its vertices and faces.
struct Content
{
  std::set<std::tuple<Place, double, Index, bool, bool>> vertices;
  std::set<std::pair<std::array<Place, 3>, Index>> faces;
  std::set<std::tuple<Place, Place, Index>> curves;

  explicit Content(const EditableSurface& surface)
  {
    for (const Index v : verticesOf(surface))
    {
      this->vertices.emplace(placeOf(surface.point(v)), surface.size(v), surface.guess(v),
        surface.isPinned(v), surface.isLocked(v));
    }
    for (const Index e : edgesOf(surface))
    {
      const Index f = EditableSurface::faceOf(e);
      this->curves.emplace(placeOf(surface.point(surface.from(e))),
        placeOf(surface.point(surface.to(e))), surface.curve(e));
      std::array<Place, 3> corners = { placeOf(surface.corner(f, 0)), placeOf(surface.corner(f, 1)),
        placeOf(surface.corner(f, 2)) };
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      this->faces.emplace(corners, surface.label(f));
    }
  }
  bool operator==(const Content& other) const
  {
    return this->vertices == other.vertices && this->faces == other.faces &&
      this->curves == other.curves;
  }
};

} // namespace evolving::editing

#endif
