// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FeatureCapture/LabelIslands.h"

#include "Remeshing/EditingChecks.h"
#include "Remeshing/RemeshingShapes.h"
#include "StartSurface/PrimitiveSurfaces.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using namespace evolving;

constexpr Index North = 4;
constexpr Index South = 7;

/// A sphere whose halves have two labels.
EditableSurface halves()
{
  EditableSurface surface = shapes::sized(icosphere(3), 0.1);
  for (const Index f : editing::facesOf(surface))
  {
    const double height =
      surface.corner(f, 0).z() + surface.corner(f, 1).z() + surface.corner(f, 2).z();
    surface.setLabel(f, height > 0.0 ? North : South);
  }
  return surface;
}

std::vector<Index> labelsOf(const EditableSurface& surface)
{
  std::vector<Index> labels;
  for (const Index f : editing::facesOf(surface))
  {
    labels.push_back(surface.label(f));
  }
  return labels;
}

/// A vertex far from the equator.
Index nearPole(const EditableSurface& surface)
{
  Index best = 0;
  for (const Index v : editing::verticesOf(surface))
  {
    best = surface.point(v).z() > surface.point(best).z() ? v : best;
  }
  return best;
}

TEST(LabelIslands, AreNotThereWhereLabelsAreInOnePiece)
{
  EditableSurface surface = halves();
  const std::vector<Index> before = labelsOf(surface);
  joinIslands(surface);
  EXPECT_EQ(labelsOf(surface), before);
}

TEST(LabelIslands, OfSomeFacesGetTheLabelAroundThem)
{
  EditableSurface surface = halves();
  const std::vector<Index> before = labelsOf(surface);
  Index edge = NoIndex;
  surface.forEachOutgoing(nearPole(surface), [&](Index e) { edge = e; });
  surface.setLabel(EditableSurface::faceOf(edge), South);
  surface.setLabel(EditableSurface::faceOf(surface.opposite(edge)), South);
  EXPECT_NE(labelsOf(surface), before);
  joinIslands(surface);
  EXPECT_EQ(labelsOf(surface), before);
}

TEST(LabelIslands, WithAnInnerVertexStay)
{
  EditableSurface surface = halves();
  surface.forEachOutgoing(
    nearPole(surface), [&](Index e) { surface.setLabel(EditableSurface::faceOf(e), South); });
  const std::vector<Index> before = labelsOf(surface);
  joinIslands(surface);
  EXPECT_EQ(labelsOf(surface), before);
}

TEST(LabelIslands, ThatAreAllOfTheirLabelStay)
{
  EditableSurface surface = halves();
  surface.setLabel(0, 9);
  joinIslands(surface);
  EXPECT_EQ(surface.label(0), 9);
}

} // namespace
