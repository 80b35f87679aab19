// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Features/TargetTips.h"

#include "Shapes/CreasedShapes.h"
#include "Shapes/MeshVariants.h"

#include <gtest/gtest.h>

#include <vector>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

std::vector<Index> tips(const SurfaceMesh& mesh)
{
  return tipsOf(TargetTriangles(mesh));
}

} // namespace

TEST(TargetTips, AreMorePointedThanATetrahedron)
{
  for (const Index sides : { 4, 6, 40 })
  {
    EXPECT_EQ(tips(pyramid(sides, 178.0)).size(), 1U) << sides;
    EXPECT_EQ(tips(pyramid(sides, 182.0)).size(), 0U) << sides;
  }
}

TEST(TargetTips, HaveFacesAllAround)
{
  EXPECT_EQ(tips(pyramid(6, 150.0)).size(), 1U);
  const SurfaceMesh open = without(pyramid(6, 150.0), [](Index face) { return face == 0; });
  EXPECT_EQ(tips(open).size(), 0U);
}
