// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// The data of vtkSurfaceEvolution's input on its output.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "DressedSurfaces.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

//------------------------------------------------------------------------------
/// A sphere that shrinks to two thirds of its radius.
void SetUpShrinking(vtkSurfaceEvolution* filter, vtkPolyData* start, int remeshing)
{
  SetUpCurvatureFlow(filter, start, 0.01, 14);
  filter->SetRemeshing(remeshing);
}

//------------------------------------------------------------------------------
TEST(EvolvedData, TheStartsElementsKeepAllAsItIs)
{
  const auto start = Sample::Dressed(Sample::Icosphere(2));
  for (const int remeshing : { vtkSurfaceEvolution::OFF, vtkSurfaceEvolution::AUTOMATIC })
  {
    vtkNew<vtkSurfaceEvolution> filter;
    SetUpShrinking(filter, start, remeshing);
    filter->Update();
    EXPECT_TRUE(HasSameData(start, filter->GetOutput()));
    EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "Height");
    EXPECT_EQ(FieldText(filter->GetOutput(), "Patient"), "Anna");
  }
}

//------------------------------------------------------------------------------
TEST(EvolvedData, NewElementsHaveTheDataOfWhereTheyComeFrom)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpShrinking(filter, Sample::Dressed(Sample::Icosphere(3)), vtkSurfaceEvolution::UNIFORM);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  ASSERT_LT(output->GetNumberOfPoints(), 400); // of 642
  // Edges are .15 long: a point between three others of a sphere is .003 below it.
  EXPECT_TRUE(HasDataOfDirections(output, 0.01, 0.15));
  EXPECT_TRUE(HasCellDataOfDirections(output, 0.15));
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Height");
  EXPECT_STREQ(output->GetCellData()->GetVectors()->GetName(), "Middle");
  EXPECT_EQ(FieldText(output, "Patient"), "Anna");
}

//------------------------------------------------------------------------------
TEST(EvolvedData, NewElementsHaveNoIdsOfOthers)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpShrinking(filter, Sample::Dressed(Sample::Icosphere(3)), vtkSurfaceEvolution::UNIFORM);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  for (const char* name : { "Number", "Pedigree", "vtkGhostType" })
  {
    EXPECT_FALSE(output->GetPointData()->HasArray(name)) << name;
  }
  EXPECT_FALSE(output->GetCellData()->HasArray("CellNumber"));
  filter->UpdateTimeStep(0.0);
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("Number")); // they are its own still
}

//------------------------------------------------------------------------------
TEST(EvolvedData, PartsOfPolygonsShareItsDataButNotItsId)
{
  vtkNew<vtkSurfaceEvolution> filter;
  const auto start = Sample::Dressed(Sample::CubeSphere(6));
  SetUpShrinking(filter, start, vtkSurfaceEvolution::UNIFORM);
  filter->UpdateTimeStep(0.0);
  vtkPolyData* output = filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfCells(), 2 * start->GetNumberOfCells());
  EXPECT_FALSE(output->GetCellData()->HasArray("CellNumber"));
  EXPECT_TRUE(SameBits(
    output->GetPointData()->GetArray("Number"), start->GetPointData()->GetArray("Number")));
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    ASSERT_EQ(output->GetCellData()->GetArray("Side")->GetTuple1(i),
      start->GetCellData()->GetArray("Side")->GetTuple1(i / 2));
  }
}

//------------------------------------------------------------------------------
TEST(EvolvedData, ASoupHasTheDataOfTheFirstOfCoincidentPoints)
{
  const auto whole = Sample::Icosphere(1);
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpShrinking(filter, Sample::Dressed(Sample::Soup(whole)), vtkSurfaceEvolution::OFF);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), whole->GetNumberOfPoints());
  EXPECT_TRUE(HasDataOfDirections(filter->GetOutput(), 0.02, 0.02));
  EXPECT_TRUE(HasCellDataOfDirections(filter->GetOutput(), 0.2));
  EXPECT_TRUE(filter->GetOutput()->GetCellData()->HasArray("CellNumber"));
}

//------------------------------------------------------------------------------
TEST(EvolvedData, StatesThatWereDroppedComeAgainWithTheirData)
{
  vtkNew<vtkSurfaceEvolution> few;
  SetUpShrinking(few, Sample::Dressed(Sample::Icosphere(4)), vtkSurfaceEvolution::UNIFORM);
  few->SetCacheLimit(1);
  for (const int step : { 11, 5, 3, 14 })
  {
    few->UpdateTimeStep(step * 0.01);
    EXPECT_TRUE(HasDataOfDirections(few->GetOutput(), 0.01, 0.08)) << step;
    EXPECT_TRUE(HasCellDataOfDirections(few->GetOutput(), 0.08)) << step;
  }
  EXPECT_EQ(few->GetNumberOfSolves(), 1);
}

//------------------------------------------------------------------------------
TEST(EvolvedData, OtherDataAreNoOtherFlow)
{
  const auto start = Sample::Dressed(Sample::Icosphere(2));
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpShrinking(filter, start, vtkSurfaceEvolution::UNIFORM);
  filter->Update();
  const auto other = Sample::Surface::New();
  other->DeepCopy(start);
  other->GetPointData()->GetArray("Height")->Fill(3.0);
  filter->SetInputData(other);
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
  double range[2];
  filter->GetOutput()->GetPointData()->GetArray("Height")->GetRange(range);
  EXPECT_DOUBLE_EQ(range[0], 3.0);
  EXPECT_DOUBLE_EQ(range[1], 3.0);
}

//------------------------------------------------------------------------------
TEST(EvolvedData, NotANumberStaysWhereItIs)
{
  const auto start = Sample::Dressed(Sample::Icosphere(3));
  vtkDataArray* height = start->GetPointData()->GetArray("Height");
  height->SetTuple1(100, vtkMath::Nan());
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpShrinking(filter, start, vtkSurfaceEvolution::UNIFORM);
  filter->Update();
  vtkDataArray* found = filter->GetOutput()->GetPointData()->GetArray("Height");
  int numbers = 0;
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
  {
    numbers += std::isfinite(found->GetTuple1(i)) ? 1 : 0;
  }
  EXPECT_GE(numbers, found->GetNumberOfTuples() - 7); // the point's neighbours at most
}

} // namespace
