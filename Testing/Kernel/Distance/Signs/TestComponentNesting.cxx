// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Signs/ComponentNesting.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Polyhedra.h"
#include "Shapes/Spheres.h"

#include <gtest/gtest.h>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

/// Several meshes in one, each a component.
struct Components
{
  explicit Components(const std::vector<SurfaceMesh>& parts)
  {
    for (std::size_t n = 0; n < parts.size(); ++n)
    {
      mesh = merged(mesh, parts[n]);
      ofFace.resize(static_cast<std::size_t>(mesh.faceCount()), static_cast<Index>(n));
    }
    all = surfaceComponents(mesh, TriangleEdges(mesh), ofFace, static_cast<Index>(parts.size()));
  }

  SurfaceMesh mesh;
  std::vector<Index> ofFace;
  std::vector<SurfaceComponent> all;
};

} // namespace

TEST(ComponentNesting, MeasuresComponents)
{
  const Components parts({ box(Vec3(0, 0, 0), Vec3(1, 2, 3)), reversed(sphere(2)), bowl(2, 0.2) });
  EXPECT_NEAR(parts.all[0].volume, 6.0, 1e-12);
  EXPECT_NEAR(parts.all[0].area, 22.0, 1e-12);
  EXPECT_TRUE(parts.all[0].isClosed);
  EXPECT_LT(parts.all[1].volume, -3.0);
  EXPECT_TRUE(parts.all[1].isClosed);
  EXPECT_FALSE(parts.all[2].isClosed);
}

TEST(ComponentNesting, FindsTheOutermostShell)
{
  const Components parts({ sphere(2, 0.2), sphere(2, 1.0), sphere(2, 0.5), sphere(2, 2.0),
    sphere(2, 0.4, Vec3(5, 0, 0)), bowl(2, 0.2) });
  EXPECT_EQ(outermostEnclosing(parts.mesh, parts.all, parts.ofFace),
    (std::vector<Index>{ 3, 3, 3, 3, 4, 5 }));
}

TEST(ComponentNesting, DoesNotTakeAnOverlapForAnEnclosure)
{
  // Wherever the largest face of one is, some of them lie inside the other.
  const Vec3 places[] = { Vec3(0.6, 0, 0), Vec3(-0.6, 0, 0), Vec3(0, 0.6, 0), Vec3(0, 0, -0.6) };
  for (const Vec3& place : places)
  {
    const Components parts({ sphere(3), reversed(sphere(3, 1.0, place)) });
    EXPECT_EQ(
      outermostEnclosing(parts.mesh, parts.all, parts.ofFace), (std::vector<Index>{ 0, 1 }));
  }
}

TEST(ComponentNesting, SeesWhetherBoxesIntersect)
{
  EXPECT_FALSE(boxesIntersect(
    Components({ sphere(1), sphere(1, 1.0, Vec3(2.5, 0, 0)), sphere(1, 1.0, Vec3(0, 2.5, 0)) })
      .all));
  EXPECT_TRUE(boxesIntersect(
    Components({ sphere(1), sphere(1, 1.0, Vec3(2.5, 0, 0)), sphere(1, 1.0, Vec3(0, 1.5, 0)) })
      .all));
  EXPECT_TRUE(boxesIntersect(Components({ sphere(1), sphere(1, 0.1) }).all));
  EXPECT_FALSE(boxesIntersect({}));
}
