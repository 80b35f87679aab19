// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/EditableSurface.h"
#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Sheets.h"
#include "Shapes/Tubes.h"
#include "StartSurface/PrimitiveSurfaces.h"
#include "StartSurface/QuadSplitting.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <vector>

namespace
{

using namespace evolving;

using namespace evolving::shapes;
using namespace evolving::editing;

/// Splits, flips and collapses at random places, so that the number of faces stays about the same.
class RandomEditor
{
public:
  explicit RandomEditor(unsigned seed)
    : Random(seed)
  {
  }

  void edit(EditableSurface& surface, Index faces)
  {
    const Index e = this->randomEdge(surface);
    switch (std::uniform_int_distribution<int>(0, this->Faces > faces ? 3 : 2)(this->Random))
    {
      case 0:
        this->split(surface, e);
        break;
      case 1:
        this->flip(surface, e);
        break;
      default:
        this->collapse(surface, e);
    }
  }
  void begin(const EditableSurface& surface) { this->Faces = surface.mesh().faceCount(); }

  int splits = 0;
  int flips = 0;
  int collapses = 0;

private:
  Index randomEdge(const EditableSurface& surface)
  {
    std::uniform_int_distribution<Index> any(0, surface.edgeSlots() - 1);
    Index e = any(this->Random);
    while (!surface.hasEdge(e))
    {
      e = any(this->Random);
    }
    return e;
  }

  void split(EditableSurface& surface, Index e)
  {
    surface.split(e, 0.5 * (surface.point(surface.from(e)) + surface.point(surface.to(e))));
    this->Faces += surface.opposite(e) == NoIndex ? 1 : 2;
    ++this->splits;
  }
  void flip(EditableSurface& surface, Index e)
  {
    if (surface.canFlip(e))
    {
      surface.flip(e);
      ++this->flips;
    }
  }
  void collapse(EditableSurface& surface, Index e)
  {
    if (!surface.isPinned(surface.from(e)) && surface.canCollapse(e))
    {
      this->Faces -= surface.opposite(e) == NoIndex ? 1 : 2;
      surface.collapse(e);
      ++this->collapses;
    }
  }

  std::mt19937 Random;
  Index Faces = 0;
};

/// Labels 0 and 1 on the sides of the plane x = 0, and curve 7 between them.
void divide(EditableSurface& surface)
{
  for (Index f = 0; f < surface.faceSlots(); ++f)
  {
    const Vec3 centre = surface.corner(f, 0) + surface.corner(f, 1) + surface.corner(f, 2);
    surface.setLabel(f, centre.x() > 0.0 ? 1 : 0);
  }
  for (const Index e : edgesOf(surface))
  {
    const Index o = surface.opposite(e);
    if (o != NoIndex && surface.label(e / 3) != surface.label(o / 3))
    {
      surface.setCurve(e, 7);
    }
  }
}

/// Where labels differ there is the curve, and nowhere else.
void expectDivided(const EditableSurface& surface)
{
  Index onCurve = 0;
  for (const Index e : edgesOf(surface))
  {
    const Index o = surface.opposite(e);
    if (o != NoIndex)
    {
      const bool isBetween = surface.label(e / 3) != surface.label(o / 3);
      ASSERT_EQ(surface.curve(e), isBetween ? 7 : NoIndex);
      onCurve += isBetween ? 1 : 0;
    }
  }
  ASSERT_GE(onCurve, 4);
}

/// Sizes and pins that edits can be followed by.
std::map<Place, bool> mark(EditableSurface& surface)
{
  std::map<Place, bool> pins;
  for (const Index v : verticesOf(surface))
  {
    surface.setSize(v, 10.0 + surface.point(v).x());
    surface.setGuess(v, 100 + v % 10);
    if (v % 9 == 4)
    {
      v % 2 == 0 ? surface.setPinned(v) : surface.setLocked(v);
      pins[placeOf(surface.point(v))] = surface.isLocked(v);
    }
  }
  return pins;
}

/// A size is linear in the place, and splits halve: so it stays; pins are where they were.
void expectMarks(const EditableSurface& surface, const std::map<Place, bool>& pins)
{
  std::map<Place, bool> found;
  for (const Index v : verticesOf(surface))
  {
    ASSERT_NEAR(surface.size(v), 10.0 + surface.point(v).x(), 1e-12);
    ASSERT_GE(surface.guess(v), 100);
    ASSERT_LT(surface.guess(v), 110);
    if (surface.isPinned(v))
    {
      found[placeOf(surface.point(v))] = surface.isLocked(v);
    }
  }
  ASSERT_EQ(found, pins);
}

void expectSoundUnderEdits(const SurfaceMesh& mesh, unsigned seed)
{
  const Kind kind = kindOf(mesh);
  EditableSurface surface(mesh);
  divide(surface);
  const std::map<Place, bool> pins = mark(surface);
  RandomEditor editor(seed);
  editor.begin(surface);
  for (int batch = 0; batch < 20; ++batch)
  {
    for (int i = 0; i < 300; ++i)
    {
      editor.edit(surface, mesh.faceCount());
    }
    ASSERT_NO_FATAL_FAILURE(expectSound(surface, kind)) << "batch " << batch;
    ASSERT_NO_FATAL_FAILURE(expectDivided(surface)) << "batch " << batch;
    ASSERT_NO_FATAL_FAILURE(expectMarks(surface, pins)) << "batch " << batch;
    if (batch % 3 == 2)
    {
      const SurfaceMesh before = surface.mesh();
      const Content content(surface);
      surface.compact();
      ASSERT_TRUE(surface.mesh() == before && Content(surface) == content);
    }
  }
  EXPECT_GT(editor.splits, 1000);
  EXPECT_GT(editor.flips, 300);
  EXPECT_GT(editor.collapses, 300);
}

TEST(RandomEditing, KeepsSpheres)
{
  expectSoundUnderEdits(icosphere(2), 1);
  expectSoundUnderEdits(icosphere(3), 2);
}

TEST(RandomEditing, KeepsTori)
{
  expectSoundUnderEdits(shapes::torus(16, 8, 2.0, 0.7), 3);
  expectSoundUnderEdits(splitQuads(quadTorus(7, 5, 2.0, 0.7)), 4);
}

TEST(RandomEditing, KeepsHigherGenus)
{
  expectSoundUnderEdits(
    shapes::transformed(splitQuads(slabWithHoles(3)), 1.0, Vec3(-3.2, 0, 0)), 5);
}

TEST(RandomEditing, KeepsBoundaries)
{
  expectSoundUnderEdits(shapes::transformed(shapes::sheet(10, true), 2.0, Vec3(-0.9, -1, 0)), 6);
  expectSoundUnderEdits(splitQuads(annulus(24)), 7);
  expectSoundUnderEdits(shapes::tube(12, 8, 1.0, [](double) { return 1.0; }), 8);
}

TEST(RandomEditing, KeepsComponentsApart)
{
  const SurfaceMesh spheres = shapes::merged(icosphere(1), icosphere(2, 3.0));
  expectSoundUnderEdits(shapes::merged(spheres, shapes::disc(4)), 9);
}

} // namespace
