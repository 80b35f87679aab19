// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkTangentialRedistribution: elements become even; shape, cells, ids and data stay.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{

using Sample::Point;

//------------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<Array> Numbers(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->InsertNextTuple1(static_cast<double>(i));
  }
  return array;
}

//------------------------------------------------------------------------------
TEST(TangentialRedistribution, CellsIdsAndAllDataStay)
{
  const auto surface = Sample::Mapped(Sample::Icosphere(2), Sample::TowardsThePole);
  const vtkIdType points = surface->GetNumberOfPoints();
  vtkNew<vtkCellArray> vertices;
  const vtkIdType vertex = 3;
  vertices->InsertNextCell(1, &vertex);
  surface->SetVerts(vertices);
  surface->GetPointData()->AddArray(Numbers<vtkIntArray>("Id", points));
  surface->GetPointData()->SetScalars(Numbers<vtkDoubleArray>("Heat", points));
  surface->GetCellData()->AddArray(Numbers<vtkIntArray>("Part", surface->GetNumberOfCells()));
  surface->GetFieldData()->AddArray(Numbers<vtkDoubleArray>("Source", 3));
  const auto output = Redistributed(surface);
  EXPECT_EQ(Sample::PolygonsOf(output), Sample::PolygonsOf(surface));
  EXPECT_EQ(output->GetNumberOfVerts(), 1);
  const auto same = [](vtkFieldData* a, vtkFieldData* b, const char* name)
  { return SameBits(a->GetArray(name), b->GetArray(name)); };
  EXPECT_TRUE(same(surface->GetPointData(), output->GetPointData(), "Id"));
  EXPECT_TRUE(same(surface->GetPointData(), output->GetPointData(), "Heat"));
  EXPECT_TRUE(same(surface->GetCellData(), output->GetCellData(), "Part"));
  EXPECT_TRUE(same(surface->GetFieldData(), output->GetFieldData(), "Source"));
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Heat");
}

//------------------------------------------------------------------------------
TEST(TangentialRedistribution, TheInputIsNotChanged)
{
  const auto surface = Sample::Mapped(Sample::Icosphere(1), Sample::TowardsThePole);
  const std::vector<Point> before = Sample::CoordinatesOf(surface);
  Redistributed(surface);
  EXPECT_EQ(Sample::CoordinatesOf(surface), before);
  EXPECT_EQ(surface->GetPointData()->GetNumberOfArrays(), 0);
}

//------------------------------------------------------------------------------
TEST(TangentialRedistribution, ArraysAreNamedAsPromised)
{
  const auto output = Redistributed(Sample::Icosphere(2));
  const std::vector<std::string> expected = { "Normals", "MeanCurvature", "CoVolume",
    "TangentialVelocity", "RedistributionPotential" };
  EXPECT_EQ(ArrayNames(output->GetPointData()), Sorted(expected));
  EXPECT_TRUE(IsFinite(output));
  EXPECT_NEAR(output->GetPointData()->GetArray("MeanCurvature")->GetTuple1(161), 2.0, 0.1);
}

//------------------------------------------------------------------------------
TEST(TangentialRedistribution, AnUnevenSphereBecomesEvenAndStaysOnItself)
{
  const auto surface = Sample::Mapped(Sample::Icosphere(3), Sample::TowardsThePole);
  const auto output = Redistributed(surface,
    [](vtkTangentialRedistribution* filter)
    {
      filter->SetNumberOfSteps(200);
      filter->SetVolumeRedistribution(1.0);
      filter->SetAngleRedistribution(1.0);
    });
  EXPECT_GT(SpreadOfAreas(surface), 0.4);
  EXPECT_LT(SpreadOfAreas(output), 0.15);
  EXPECT_GT(SmallestAngleOf(output), SmallestAngleOf(surface));
  EXPECT_GT(SmallestAngleOf(output), 40.0);
  EXPECT_LT(LargestDistance(output, surface), 1e-9);
}

//------------------------------------------------------------------------------
TEST(TangentialRedistribution, TheBunnyImprovesOnItsOwnSurface)
{
  const auto bunny = Sample::Read("bunny.ply");
  const auto output = Redistributed(bunny);
  double bounds[6];
  bunny->GetBounds(bounds);
  const double size = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  EXPECT_LT(LargestDistance(output, bunny), 1e-6 * size);
  EXPECT_GT(MeanAngleOf(output), MeanAngleOf(bunny) + 2.5);
  EXPECT_GT(SmallestAngleOf(output), SmallestAngleOf(bunny) + 5.0);
  EXPECT_LT(SpreadOfAreas(output), 1.1 * SpreadOfAreas(bunny)); // sizes stay about as they are
  EXPECT_EQ(CountBadEdges(output), 0);
  EXPECT_TRUE(IsFinite(output));
  EXPECT_EQ(output->GetPoints()->GetDataType(), bunny->GetPoints()->GetDataType());
}

//------------------------------------------------------------------------------
TEST(TangentialRedistribution, WithoutPreserveShapePointsMayLeaveTheSurface)
{
  const auto surface = Sample::Mapped(Sample::Icosphere(2), Sample::TowardsThePole);
  const auto output =
    Redistributed(surface, [](vtkTangentialRedistribution* filter) { filter->PreserveShapeOff(); });
  EXPECT_GT(LargestDistance(output, surface), 1e-6);
  EXPECT_LT(LargestDistance(output, surface), 0.2);
}

//------------------------------------------------------------------------------
TEST(TangentialRedistribution, PointsWithEqualCoordinatesStayTogether)
{
  const auto welded = Sample::Mapped(Sample::Icosphere(2), Sample::TowardsThePole);
  const auto soup = Redistributed(Sample::Soup(welded));
  EXPECT_EQ(soup->GetNumberOfPoints(), 3 * welded->GetNumberOfPolys());
  EXPECT_TRUE(SameSurface(Sample::Soup(Redistributed(welded)), soup, 1e-9));
}

//------------------------------------------------------------------------------
TEST(TangentialRedistribution, NoStepsLeaveThePoints)
{
  const auto surface = Sample::Mapped(Sample::Icosphere(2), Sample::TowardsThePole);
  const auto output = Redistributed(
    surface, [](vtkTangentialRedistribution* filter) { filter->SetNumberOfSteps(0); });
  EXPECT_TRUE(SameSurface(surface, output, 0.0));
  EXPECT_NE(output->GetPointData()->GetArray("CoVolume"), nullptr);
}

//------------------------------------------------------------------------------
TEST(TangentialRedistribution, LargeRatesAreTakenInParts)
{
  const auto surface = Sample::Mapped(Sample::Icosphere(2), Sample::TowardsThePole);
  vtkNew<vtkTangentialRedistribution> filter;
  EventLog log(filter);
  filter->SetInputData(surface);
  filter->SetNumberOfSteps(5);
  filter->SetVolumeRedistribution(100.0);
  filter->SetAngleRedistribution(30.0);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_LT(SpreadOfAreas(filter->GetOutput()), SpreadOfAreas(surface));
  EXPECT_LT(LargestDistance(filter->GetOutput(), surface), 1e-9);
}

} // namespace
