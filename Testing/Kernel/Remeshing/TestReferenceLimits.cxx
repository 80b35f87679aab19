// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Remeshing/CurvedReference.h"
#include "Remeshing/ReferenceSurface.h"
#include "Remeshing/RemeshingShapes.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

namespace
{

using namespace evolving;

TEST(ReferenceLimits, GuessesOfFormerReferencesAreNone)
{
  const SurfaceMesh mesh = shapes::bumpySphere(2);
  const CurvedReference curved(mesh);
  const OffsetReference offset(mesh, 0.1);
  const Vec3 point(0.3, -1.4, 0.5);
  constexpr Index Largest = std::numeric_limits<Index>::max();
  for (const ReferenceSurface* reference :
    std::initializer_list<const ReferenceSurface*>{ &curved, &offset })
  {
    const auto expected = reference->onSurface(point, point, 0, NoIndex);
    for (const Index guess : { mesh.faceCount(), Largest, -2, -Largest })
    {
      const auto foot = reference->onSurface(point, point, 0, guess);
      EXPECT_EQ(foot.point, expected.point);
      EXPECT_EQ(foot.triangle, expected.triangle);
    }
  }
}

TEST(ReferenceLimits, WithoutFacesIsThePointItself)
{
  const Vec3 point(0.3, -1.4, 0.5);
  for (const Index guess : { NoIndex, 0, 7 })
  {
    const auto curved = CurvedReference({}).onSurface(point, Vec3::UnitX(), 0, guess);
    const auto offset = OffsetReference({}, 0.1).onSurface(point, Vec3::UnitX(), 0, guess);
    EXPECT_EQ(curved.point, point);
    EXPECT_EQ(offset.point, point);
    EXPECT_EQ(curved.normal, Vec3::UnitX());
    EXPECT_EQ(offset.triangle, NoIndex);
  }
}

} // namespace
