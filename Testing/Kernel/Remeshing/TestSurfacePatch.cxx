// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/SurfacePatch.h"

#include "Remeshing/EdgeCollapsing.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Sheets.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace
{

using namespace evolving;
using namespace evolving::editing;

std::vector<Index> ringsAround(const EditableSurface& surface, Index vertex, int rings)
{
  std::vector<Index> vertices = { vertex };
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<Index> inner = vertices;
    for (const Index v : inner)
    {
      surface.forEachNeighbour(v, [&vertices](Index u) { vertices.push_back(u); });
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }
  return vertices;
}

/// All that can be asked of a surface, slot by slot.
struct Slots
{
  explicit Slots(const EditableSurface& surface)
  {
    for (Index v = 0; v < surface.vertexSlots(); ++v)
    {
      this->Places.push_back(placeOf(surface.point(v)));
      this->Sizes.push_back(surface.size(v));
      this->Numbers.push_back(surface.guess(v));
      this->Numbers.push_back(surface.isPinned(v) ? 1 : 0);
      this->Numbers.push_back(surface.isLocked(v) ? 1 : 0);
      this->Numbers.push_back(surface.hasVertex(v) ? 1 : 0);
      if (surface.hasVertex(v))
      {
        surface.forEachOutgoing(v, [this](Index e) { this->Numbers.push_back(e); });
      }
    }
    for (Index e = 0; e < surface.edgeSlots(); ++e)
    {
      this->Numbers.push_back(surface.from(e));
      this->Numbers.push_back(surface.opposite(e));
      this->Numbers.push_back(surface.curve(e));
      this->Numbers.push_back(surface.label(EditableSurface::faceOf(e)));
    }
  }

  bool operator==(const Slots& other) const
  {
    return this->Places == other.Places && this->Sizes == other.Sizes &&
      this->Numbers == other.Numbers;
  }

  std::vector<Place> Places;
  std::vector<double> Sizes;
  std::vector<Index> Numbers;
};

/// One edit at an edge, of a kind by number. @return whether it was possible
bool edit(EditableSurface& surface, Index e, unsigned kind)
{
  const Index v = surface.from(e);
  switch (kind % 4)
  {
    case 0:
      if (surface.canFlip(e))
      {
        surface.flip(e);
        return true;
      }
      return false;
    case 1:
      return collapseEdge(surface, e, {});
    case 2:
      surface.split(e, 0.5 * (surface.point(v) + surface.point(surface.to(e))));
      return true;
    default:
      surface.setPoint(v, 1.1 * surface.point(v));
      surface.setSize(v, 7.0);
      surface.setGuess(v, 3);
      surface.setPinned(v);
      surface.setLocked(v);
      surface.setLabel(EditableSurface::faceOf(e), 5);
      return true;
  }
}

/// A closed surface, or one with boundary and curves.
EditableSurface someSurface(bool isOpen)
{
  EditableSurface surface =
    shapes::sized(isOpen ? shapes::sheet(8, true) : shapes::shakenSphere(2, 0.1, 1), 0.3);
  for (Index e = 0; e < surface.edgeSlots(); e += 17)
  {
    surface.setCurve(e, e);
    surface.setLabel(EditableSurface::faceOf(e), e);
  }
  return surface;
}

TEST(SurfacePatch, TakesEveryEditBack)
{
  for (const bool isOpen : { false, true })
  {
    EditableSurface surface = someSurface(isOpen);
    const Slots before(surface);
    std::mt19937 random(7);
    int edits = 0;
    for (int trial = 0; trial < 400; ++trial)
    {
      const auto e = static_cast<Index>(random() % static_cast<unsigned>(surface.edgeSlots()));
      const SurfacePatch patch(surface, ringsAround(surface, surface.from(e), 2));
      edits += edit(surface, e, static_cast<unsigned>(trial)) ? 1 : 0;
      patch.restore(surface);
      ASSERT_TRUE(Slots(surface) == before) << "trial " << trial;
    }
    EXPECT_GT(edits, 200);
    expectConsistent(surface);
  }
}

TEST(SurfacePatch, TakesSeveralEditsBackTogether)
{
  EditableSurface surface = someSurface(false);
  std::mt19937 random(3);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Slots before(surface);
    const auto center = static_cast<Index>(random() % static_cast<unsigned>(surface.vertexSlots()));
    const SurfacePatch patch(surface, ringsAround(surface, center, 4));
    for (unsigned kind = 0; kind < 8; ++kind)
    {
      const std::vector<Index> inner =
        ringsAround(surface, surface.hasVertex(center) ? center : 0, 1);
      Index edge = NoIndex;
      surface.forEachOutgoing(inner[random() % inner.size()], [&edge](Index e) { edge = e; });
      if (surface.hasVertex(center))
      {
        edit(surface, edge, kind);
      }
    }
    patch.restore(surface);
    ASSERT_TRUE(Slots(surface) == before) << "trial " << trial;
  }
}

} // namespace
