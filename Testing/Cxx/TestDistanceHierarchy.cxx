// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkDistanceHierarchy: the boxes are those of the structures, and the numbers on them right.

#include "DataChecks.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDistanceHierarchy.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

constexpr vtkIdType SidesOfBox = 6;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Boxes(vtkPolyData* surface, int structure, int level)
{
  vtkNew<vtkDistanceHierarchy> filter;
  filter->SetInputData(surface);
  filter->SetStructure(structure);
  filter->SetLevel(level);
  filter->SetSampleDimensions(32, 32, 32);
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
double CellValue(vtkPolyData* boxes, const char* name, vtkIdType cell)
{
  return boxes->GetCellData()->GetArray(name)->GetTuple1(cell);
}

//------------------------------------------------------------------------------
/// Bounds of box number i.
std::vector<double> BoundsOf(vtkPolyData* boxes, vtkIdType i)
{
  double bounds[6];
  double other[6];
  boxes->GetCellBounds(SidesOfBox * i, bounds);
  for (vtkIdType side = 1; side < SidesOfBox; ++side)
  {
    boxes->GetCellBounds(SidesOfBox * i + side, other);
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds[2 * axis] = std::min(bounds[2 * axis], other[2 * axis]);
      bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], other[2 * axis + 1]);
    }
  }
  return std::vector<double>(bounds, bounds + 6);
}

//------------------------------------------------------------------------------
/// Is every point in some box, to a tolerance?
bool CoverAllPoints(vtkPolyData* boxes, vtkPolyData* surface)
{
  std::vector<std::vector<double>> bounds;
  for (vtkIdType i = 0; i < boxes->GetNumberOfPolys() / SidesOfBox; ++i)
  {
    bounds.push_back(BoundsOf(boxes, i));
  }
  const auto points = Sample::CoordinatesOf(surface);
  return std::all_of(points.begin(), points.end(),
    [&](const Sample::Point& p)
    {
      return std::any_of(bounds.begin(), bounds.end(),
        [&](const std::vector<double>& b)
        {
          double tolerance[3] = { 1e-5, 1e-5, 1e-5 };
          return vtkMath::PointIsWithinBounds(p.data(), b.data(), tolerance) != 0;
        });
    });
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, TheRootOfTheTreeIsOneBoxAroundTheSurface)
{
  const auto surface = Sample::Icosphere(3);
  const auto root = Boxes(surface, vtkDistanceHierarchy::AABB_TREE, 0);
  ASSERT_EQ(root->GetNumberOfPolys(), SidesOfBox);
  EXPECT_EQ(CountBadEdges(root), 0);
  EXPECT_GT(VolumeOf(root), 7.5);
  EXPECT_LT(VolumeOf(root), 8.5);
  EXPECT_EQ(CellValue(root, "Level", 0), 0.0);
  EXPECT_EQ(CellValue(root, "NumberOfTriangles", 0), 0.0);
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, LeavesOfTheTreeCoverTheSurface)
{
  const auto surface = Sample::Icosphere(3);
  const auto leaves = Boxes(surface, vtkDistanceHierarchy::AABB_TREE, -1);
  EXPECT_TRUE(CoverAllPoints(leaves, surface));
  double triangles = 0.0;
  for (vtkIdType cell = 0; cell < leaves->GetNumberOfPolys(); cell += SidesOfBox)
  {
    EXPECT_GE(CellValue(leaves, "NumberOfTriangles", cell), 1.0);
    EXPECT_GE(CellValue(leaves, "Level", cell), 1.0);
    triangles += CellValue(leaves, "NumberOfTriangles", cell);
  }
  // A triangle may lie in several leaves, but in one at least.
  EXPECT_GE(triangles, static_cast<double>(surface->GetNumberOfPolys()));
  EXPECT_LT(VolumeOf(leaves), 0.5 * VolumeOf(Boxes(surface, vtkDistanceHierarchy::AABB_TREE, 0)));
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, LevelsOfTheTreeHaveAtMostTwiceTheBoxes)
{
  const auto surface = Sample::Icosphere(3);
  vtkIdType before = 1;
  for (int level = 1; level <= 4; ++level)
  {
    const auto boxes = Boxes(surface, vtkDistanceHierarchy::AABB_TREE, level);
    const vtkIdType count = boxes->GetNumberOfPolys() / SidesOfBox;
    EXPECT_GT(count, before);
    EXPECT_LE(count, 2 * before);
    EXPECT_EQ(boxes->GetCellData()->GetArray("Level")->GetRange()[0], level);
    EXPECT_EQ(boxes->GetCellData()->GetArray("Level")->GetRange()[1], level);
    before = count;
  }
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, LeavesOfTheOctreeAreCellsOfTheGridWithTheirDistance)
{
  const auto surface = Sample::Icosphere(3);
  vtkNew<vtkMeshSDF> distance;
  distance->SetInputData(surface);
  distance->SetSampleDimensions(32, 32, 32);
  distance->SetMethodToBruteForce();
  distance->Update();
  vtkImageData* grid = distance->GetOutput();
  const double h = grid->GetSpacing()[0];
  const auto leaves = Boxes(surface, vtkDistanceHierarchy::OCTREE, -1);
  EXPECT_TRUE(CoverAllPoints(leaves, surface));
  ASSERT_GT(leaves->GetNumberOfPolys(), SidesOfBox * 1000);
  for (vtkIdType i = 0; i < leaves->GetNumberOfPolys() / SidesOfBox; ++i)
  {
    const std::vector<double> b = BoundsOf(leaves, i);
    double center[3];
    double sample[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ASSERT_NEAR(b[2 * axis + 1] - b[2 * axis], h, 1e-5);
      center[axis] = 0.5 * (b[2 * axis] + b[2 * axis + 1]);
    }
    const vtkIdType id = grid->FindPoint(center);
    grid->GetPoint(id, sample);
    ASSERT_NEAR(vtkMath::Distance2BetweenPoints(center, sample), 0.0, 1e-10);
    const double d = std::abs(grid->GetPointData()->GetScalars()->GetTuple1(id));
    ASSERT_NEAR(CellValue(leaves, "Distance", SidesOfBox * i), d, 1e-5);
    ASSERT_LE(d, 0.87 * h); // half the diagonal of a cell that meets the surface
  }
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, AllLevelsTogetherAreTheLevels)
{
  const auto surface = Sample::Icosphere(2);
  for (const int structure : { vtkDistanceHierarchy::AABB_TREE, vtkDistanceHierarchy::OCTREE })
  {
    vtkIdType sum = 0;
    int level = 0;
    for (vtkIdType count = 1; count > 0; sum += count, ++level)
    {
      count = Boxes(surface, structure, level)->GetNumberOfPolys();
    }
    const auto all = Boxes(surface, structure, -2);
    EXPECT_EQ(all->GetNumberOfPolys(), sum);
    EXPECT_EQ(all->GetCellData()->GetArray("Level")->GetRange()[0], 0.0);
    EXPECT_EQ(all->GetCellData()->GetArray("Level")->GetRange()[1], level - 2);
    EXPECT_GT(sum, Boxes(surface, structure, -1)->GetNumberOfPolys());
  }
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, TheLastLevelOfTheOctreeIsItsLeaves)
{
  const auto surface = Sample::Icosphere(2);
  const auto leaves = Boxes(surface, vtkDistanceHierarchy::OCTREE, -1);
  const auto last =
    Boxes(surface, vtkDistanceHierarchy::OCTREE, static_cast<int>(CellValue(leaves, "Level", 0)));
  EXPECT_TRUE(SameBits(
    leaves->GetCellData()->GetArray("Distance"), last->GetCellData()->GetArray("Distance")));
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, BoxesFarFromTheOriginAreAsExactAsTheSurface)
{
  const auto surface = Sample::Icosphere(2, 1.0, { 1e6, 1e6, 1e6 });
  const auto leaves = Boxes(surface, vtkDistanceHierarchy::AABB_TREE, -1);
  EXPECT_EQ(leaves->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_NEAR(leaves->GetBounds()[1], surface->GetBounds()[1], 1e-3);
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, EachStructureHasItsArrays)
{
  using Names = std::vector<std::string>;
  const auto surface = Sample::Icosphere(1);
  EXPECT_EQ(ArrayNames(Boxes(surface, vtkDistanceHierarchy::AABB_TREE, -1)->GetCellData()),
    Names({ "Level", "NumberOfTriangles" }));
  EXPECT_EQ(ArrayNames(Boxes(surface, vtkDistanceHierarchy::OCTREE, -1)->GetCellData()),
    Names({ "Distance", "Level" }));
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, ALevelBelowTheLeavesHasNoBoxes)
{
  for (const int structure : { vtkDistanceHierarchy::AABB_TREE, vtkDistanceHierarchy::OCTREE })
  {
    EXPECT_EQ(Boxes(Sample::Icosphere(1), structure, 60)->GetNumberOfPolys(), 0);
  }
}

//------------------------------------------------------------------------------
TEST(DistanceHierarchy, ModelBoundsPlaceTheOctree)
{
  vtkNew<vtkDistanceHierarchy> filter;
  filter->SetInputData(Sample::Icosphere(2));
  filter->SetStructureToOctree();
  filter->SetSampleDimensions(11, 11, 11);
  filter->SetModelBounds(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
  filter->Update();
  const std::vector<double> b = BoundsOf(filter->GetOutput(), 0);
  EXPECT_NEAR(b[1] - b[0], 0.4, 1e-6);
}

} // namespace
