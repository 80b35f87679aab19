// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Several ranks: one of them has the surface, the others its arrays without tuples, and every one
// its part of a grid.

#include "DataChecks.h"
#include "SampleSurfaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDistanceHierarchy.h"
#include "vtkFloatArray.h"
#include "vtkIcosphereSource.h"
#include "vtkImageData.h"
#include "vtkLabelSurfaces.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

//------------------------------------------------------------------------------
/// Expects that piece 1 of 2 is piece 0 without its tuples.
void ExpectEmptySecondPiece(vtkPolyDataAlgorithm* filter)
{
  ASSERT_TRUE(filter->UpdatePiece(0, 2, 0));
  vtkNew<vtkPolyData> first;
  first->ShallowCopy(filter->GetOutput());
  EXPECT_GT(first->GetNumberOfPoints(), 0);
  ASSERT_TRUE(filter->UpdatePiece(1, 2, 0));
  vtkPolyData* second = filter->GetOutput();
  EXPECT_EQ(second->GetNumberOfPoints(), 0);
  EXPECT_EQ(second->GetNumberOfCells(), 0);
  EXPECT_EQ(ArrayNames(second->GetPointData()), ArrayNames(first->GetPointData()));
  EXPECT_EQ(ArrayNames(second->GetCellData()), ArrayNames(first->GetCellData()));
  for (int a = 0; a < second->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = second->GetPointData()->GetArray(a);
    EXPECT_EQ(array->GetNumberOfTuples(), 0);
    EXPECT_EQ(
      array->GetNumberOfComponents(), first->GetPointData()->GetArray(a)->GetNumberOfComponents());
    EXPECT_EQ(array->GetDataType(), first->GetPointData()->GetArray(a)->GetDataType());
  }
}

//------------------------------------------------------------------------------
TEST(Ranks, EvolutionAndItsHistory)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(0, Sample::Icosphere(1, 1.5));
  filter->SetInputData(1, Sample::SphereImage(9, 2.0, 1.0));
  filter->SetNumberOfSteps(2);
  ExpectEmptySecondPiece(filter);
  auto* history = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(history->GetNumberOfRows(), 0);
  EXPECT_EQ(history->GetNumberOfColumns(), 9);
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
}

//------------------------------------------------------------------------------
TEST(Ranks, EvolutionWithoutField)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(1));
  filter->SetNumberOfSteps(2);
  ExpectEmptySecondPiece(filter);
}

//------------------------------------------------------------------------------
TEST(Ranks, TheHistoryOfTheSecondRank)
{
  vtkNew<vtkSurfaceEvolution> filter;
  filter->SetInputData(Sample::Icosphere(1));
  filter->SetNumberOfSteps(2);
  ASSERT_TRUE(filter->UpdatePiece(1, 2, 0));
  auto* history = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(history->GetNumberOfColumns(), 9);
  EXPECT_EQ(history->GetNumberOfRows(), 0);
  EXPECT_EQ(filter->GetNumberOfSolves(), 0);
}

//------------------------------------------------------------------------------
TEST(Ranks, Redistribution)
{
  const auto surface = Sample::Icosphere(1);
  vtkNew<vtkFloatArray> heat;
  heat->SetName("Heat");
  heat->SetNumberOfComponents(2);
  heat->SetNumberOfTuples(surface->GetNumberOfPoints());
  heat->Fill(1.0);
  surface->GetPointData()->AddArray(heat);
  vtkNew<vtkTangentialRedistribution> filter;
  filter->SetInputData(surface);
  ExpectEmptySecondPiece(filter);
}

//------------------------------------------------------------------------------
TEST(Ranks, Wrap)
{
  vtkNew<vtkShrinkWrap> filter;
  filter->SetInputData(Sample::Icosphere(1));
  filter->SetSampleDimensions(16, 16, 16);
  filter->SetTargetEdgeLength(0.3);
  filter->SetNumberOfSteps(5);
  ExpectEmptySecondPiece(filter);
}

//------------------------------------------------------------------------------
TEST(Ranks, Hierarchy)
{
  vtkNew<vtkDistanceHierarchy> filter;
  filter->SetInputData(Sample::Icosphere(1));
  ExpectEmptySecondPiece(filter);
  filter->SetStructureToOctree();
  filter->SetSampleDimensions(8, 8, 8);
  ExpectEmptySecondPiece(filter);
}

//------------------------------------------------------------------------------
TEST(Ranks, Icosphere)
{
  // As for every source that makes no pieces, VTK looks at the piece when it runs first.
  vtkNew<vtkIcosphereSource> source;
  ASSERT_TRUE(source->UpdatePiece(1, 2, 0));
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
TEST(Ranks, SurfacesOfLabelsAndTheirInterfaces)
{
  const auto labels = Sample::SphereImage(9, 2.0, 1.0);
  vtkDataArray* scalars = labels->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetTuple1(i, scalars->GetTuple1(i) < 0.0 ? 1 + i % 9 / 4 : 0);
  }
  vtkNew<vtkLabelSurfaces> filter;
  filter->SetInputData(labels);
  ExpectEmptySecondPiece(filter);
  vtkPolyData* interfaces = filter->GetOutput(1);
  EXPECT_EQ(interfaces->GetNumberOfPoints(), 0);
  EXPECT_EQ(ArrayNames(interfaces->GetCellData()), std::vector<std::string>{ "BoundaryLabels" });
  EXPECT_EQ(interfaces->GetCellData()->GetArray(0)->GetNumberOfComponents(), 2);
}

//------------------------------------------------------------------------------
TEST(Ranks, EveryRankComputesItsPartOfTheGrid)
{
  vtkNew<vtkMeshSDF> whole;
  whole->SetInputData(Sample::Icosphere(2));
  whole->SetSampleDimensions(16, 16, 16);
  whole->SetMethodToBruteForce();
  whole->Update();
  vtkIdType cells = 0;
  for (int piece = 0; piece < 2; ++piece)
  {
    vtkNew<vtkMeshSDF> filter;
    filter->SetInputData(Sample::Icosphere(2));
    filter->SetSampleDimensions(16, 16, 16);
    filter->SetMethodToBruteForce();
    ASSERT_TRUE(filter->UpdatePiece(piece, 2, 0));
    vtkImageData* part = filter->GetOutput();
    cells += part->GetNumberOfCells();
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      double p[3];
      part->GetPoint(i, p);
      const vtkIdType id = whole->GetOutput()->FindPoint(p);
      ASSERT_EQ(part->GetPointData()->GetScalars()->GetTuple1(i),
        whole->GetOutput()->GetPointData()->GetScalars()->GetTuple1(id));
    }
  }
  EXPECT_EQ(cells, whole->GetOutput()->GetNumberOfCells());
}

} // namespace
