// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Distance/Sweeping/DistanceOctree.h"

#include "Errors.h"
#include "Shapes/MeshVariants.h"
#include "Shapes/Spheres.h"
#include "Shapes/Tubes.h"
#include "ThreadedExecution.h"
#include "Trees/AABBTree.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <set>

using namespace evolving;
using namespace evolving::shapes;

namespace
{

using Cells = std::set<std::array<int, 3>>;

Cells leafCells(const DistanceOctree& octree)
{
  Cells cells;
  for (const DistanceOctree::Leaf& leaf : octree.leaves())
  {
    EXPECT_EQ(leaf.cell.side, 1);
    EXPECT_TRUE(cells.insert(leaf.cell.corner).second) << "a leaf twice";
  }
  return cells;
}

/// The samples whose cells meet a triangle, by trying all pairs.
Cells cellsMeetingTriangles(const SurfaceMesh& mesh, const DistanceGrid& grid)
{
  Cells cells;
  const Vec3 half = 0.5 * grid.spacing;
  const Extent& e = grid.extent;
  for (int k = e[4]; k <= e[5]; ++k)
  {
    for (int j = e[2]; j <= e[3]; ++j)
    {
      for (int i = e[0]; i <= e[1]; ++i)
      {
        const Vec3 center = grid.point(i, j, k);
        const Box cell(Vec3(center - half), Vec3(center + half));
        for (Index face = 0; face < mesh.faceCount(); ++face)
        {
          const Triangle triangle{ { mesh.facePoint(face, 0), mesh.facePoint(face, 1),
            mesh.facePoint(face, 2) } };
          if (overlaps(triangle, cell))
          {
            cells.insert({ i, j, k });
            break;
          }
        }
      }
    }
  }
  return cells;
}

} // namespace

TEST(DistanceOctree, LeavesAreExactlyTheCellsThatMeetTriangles)
{
  for (const SurfaceMesh& mesh : { sphere(2), torus(20, 10, 1.0, 0.3), randomSoup(40, 0.6, 3) })
  {
    const DistanceGrid grid = gridAround(boundingBox(mesh), { 17, 20, 23 }, 0.1);
    const DistanceOctree octree(AABBTree(mesh), grid);
    EXPECT_EQ(leafCells(octree), cellsMeetingTriangles(mesh, grid));
  }
}

TEST(DistanceOctree, LeavesAreTheSameWhenTheMeshSticksOutOfTheGrid)
{
  const SurfaceMesh mesh = sphere(2);
  const DistanceGrid grid = gridAround(Box(Vec3(0, 0, 0), Vec3(2, 0.5, 0.7)), { 20, 12, 12 }, 0.0);
  const DistanceOctree octree(AABBTree(mesh), grid);
  const Cells expected = cellsMeetingTriangles(mesh, grid);
  EXPECT_GT(expected.size(), 20U);
  EXPECT_EQ(leafCells(octree), expected);
}

/// A plate in the faces between two layers of cells belongs to one of them at least, wherever the
/// coordinates of these faces are rounded to.
TEST(DistanceOctree, LosesNoTriangleBetweenCellsFarAway)
{
  for (const double offset : { 0.0, 1e3, 1e6, 1e8, 1e10 })
  {
    DistanceGrid grid;
    grid.origin = offset * Vec3(1.0, -0.7, 0.3);
    grid.spacing = Vec3::Constant(0.0687);
    grid.extent = { 0, 15, 0, 15, 0, 15 };
    for (int i = 0; i < 15; ++i)
    {
      const double x = 0.5 * (grid.point(i, 0, 0).x() + grid.point(i + 1, 0, 0).x());
      const Vec3 low = grid.point(2, 2, 2);
      const Vec3 high = grid.point(13, 13, 13);
      SurfaceMesh plate;
      plate.points = { Vec3(x, low.y(), low.z()), Vec3(x, high.y(), low.z()),
        Vec3(x, high.y(), high.z()), Vec3(x, low.y(), high.z()) };
      plate.addFace({ 0, 1, 2 });
      plate.addFace({ 0, 2, 3 });
      std::set<std::array<int, 2>> columns;
      for (const auto& cell : leafCells(DistanceOctree(AABBTree(plate), grid)))
      {
        columns.insert({ cell[1], cell[2] });
      }
      EXPECT_GE(columns.size(), 12U * 12U) << "between layers " << i << " at " << offset;
    }
  }
}

TEST(DistanceOctree, CentroidsOfLeavesAreSamples)
{
  const SurfaceMesh mesh = sphere(2, 0.7, Vec3(0.1, 0.2, 0.3));
  const DistanceGrid grid = gridAround(boundingBox(mesh), { 20, 20, 20 }, 0.1);
  const DistanceOctree octree(AABBTree(mesh), grid);
  for (const DistanceOctree::Leaf& leaf : octree.leaves())
  {
    const auto& [i, j, k] = leaf.cell.corner;
    EXPECT_LT((octree.center(leaf.cell) - grid.point(i, j, k)).norm(), 1e-14);
  }
}

TEST(DistanceOctree, LeavesHoldTheDistanceToTheNearestTriangleOfAll)
{
  const SurfaceMesh mesh = sphere(3);
  const AABBTree tree(mesh);
  const DistanceOctree octree(tree, gridAround(boundingBox(mesh), { 24, 24, 24 }, 0.1));
  for (const DistanceOctree::Leaf& leaf : octree.leaves())
  {
    const ClosestTriangle closest = tree.closest(octree.center(leaf.cell));
    EXPECT_EQ(leaf.squaredDistance, closest.at.squaredDistance);
    EXPECT_EQ(leaf.triangle, closest.triangle);
  }
}

TEST(DistanceOctree, LevelsHalveAndCoverTheNext)
{
  const DistanceOctree octree(
    AABBTree(sphere(2)), gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 24, 24, 24 }, 0.1));
  ASSERT_EQ(octree.depth(), 5);
  EXPECT_EQ(octree.cells(0).size(), 1U);
  for (int level = 0; level < octree.depth(); ++level)
  {
    EXPECT_EQ(octree.cells(level).front().side, 2 * octree.cells(level + 1).front().side);
    for (const DistanceOctree::Cell& child : octree.cells(level + 1))
    {
      int parents = 0;
      for (const DistanceOctree::Cell& parent : octree.cells(level))
      {
        parents += octree.box(parent).contains(octree.center(child)) ? 1 : 0;
      }
      ASSERT_EQ(parents, 1);
    }
  }
}

TEST(DistanceOctree, StopsAtTheMaximumDepth)
{
  const AABBTree tree(sphere(2));
  const DistanceGrid grid = gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 24, 24, 24 }, 0.1);
  const DistanceOctree octree(tree, grid, {}, 2);
  EXPECT_EQ(octree.depth(), 2);
  EXPECT_EQ(octree.leaves().size(), octree.cells(2).size());
  EXPECT_EQ(octree.leaves().front().cell.side, 8);
}

TEST(DistanceOctree, IsEmptyBesideTheMesh)
{
  const DistanceGrid grid = gridAround(Box(Vec3(5, 5, 5), Vec3(6, 6, 6)), { 8, 8, 8 }, 0.0);
  EXPECT_EQ(DistanceOctree(AABBTree(sphere(1)), grid).depth(), -1);
  // In the middle of the mesh's box, where there is no triangle either.
  const DistanceGrid hollow = gridAround(Box(Vec3(0, 0, 0), Vec3(0.1, 0.1, 0.1)), { 8, 8, 8 }, 0.0);
  EXPECT_TRUE(DistanceOctree(AABBTree(sphere(1)), hollow).leaves().empty());
}

TEST(DistanceOctree, RefusesCellsThatAreNoCubes)
{
  const DistanceGrid grid = gridOver(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 10, 20, 10 });
  EXPECT_THROW(DistanceOctree(AABBTree(sphere(1)), grid), InputError);
}

TEST(DistanceOctree, StopsBeforeItHasMoreCellsThanAllowed)
{
  const AABBTree tree(sphere(2));
  const DistanceGrid grid = gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 32, 32, 32 }, 0.1);
  const int anyDepth = std::numeric_limits<int>::max();
  const std::size_t leaves = DistanceOctree(tree, grid).leaves().size();
  EXPECT_EQ(DistanceOctree(tree, grid, {}, anyDepth, leaves).leaves().size(), leaves);
  EXPECT_THROW(DistanceOctree(tree, grid, {}, anyDepth, leaves - 1), InputError);
  // Of a grid that would never fit, no more than a few levels are made.
  const DistanceGrid huge =
    gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 65536, 65536, 65536 }, 0.1);
  EXPECT_THROW(DistanceOctree(tree, huge, {}, anyDepth, 1000), InputError);
}

TEST(DistanceOctree, IsTheSameForAnyNumberOfThreads)
{
  const AABBTree tree(sphere(3));
  const DistanceGrid grid = gridAround(Box(Vec3(-1, -1, -1), Vec3(1, 1, 1)), { 32, 32, 32 }, 0.1);
  const DistanceOctree serial(tree, grid);
  for (const int threads : { 1, 2, 8 })
  {
    const DistanceOctree octree(tree, grid, threadedExecution(threads, 5));
    ASSERT_EQ(octree.leaves().size(), serial.leaves().size());
    for (std::size_t n = 0; n < serial.leaves().size(); ++n)
    {
      EXPECT_EQ(octree.leaves()[n].cell.corner, serial.leaves()[n].cell.corner);
      EXPECT_EQ(octree.leaves()[n].squaredDistance, serial.leaves()[n].squaredDistance);
    }
  }
}
