// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkMeshSDF: where the grid lies, what is known of it beforehand, and how large it may be.

#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, ExtentIsKnownBeforeTheUpdateAndThePlaceIsNot)
{
  vtkNew<vtkMeshSDF> filter;
  filter->SetInputData(Sample::Icosphere(1));
  filter->SetSampleDimensions(10, 20, 30);
  vtkInformation* information = InformationOf(filter);
  const int expected[6] = { 0, 9, 0, 19, 0, 29 };
  int extent[6];
  information->Get(Pipeline::WHOLE_EXTENT(), extent);
  EXPECT_TRUE(std::equal(extent, extent + 6, expected));
  EXPECT_FALSE(information->Has(vtkDataObject::ORIGIN()));
  EXPECT_FALSE(information->Has(vtkDataObject::SPACING()));
}

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, ModelBoundsAreTakenAsTheyAre)
{
  vtkNew<vtkMeshSDF> filter;
  filter->SetInputData(Sample::Icosphere(1));
  filter->SetSampleDimensions(11, 5, 3);
  filter->SetModelBounds(0.0, 1.0, -2.0, 2.0, -1.0, 5.0);
  vtkInformation* information = InformationOf(filter);
  ASSERT_TRUE(information->Has(vtkDataObject::ORIGIN()));
  ASSERT_TRUE(information->Has(vtkDataObject::SPACING()));
  const double origin[3] = { 0.0, -2.0, -1.0 };
  const double spacing[3] = { 0.1, 1.0, 3.0 };
  filter->Update();
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_DOUBLE_EQ(information->Get(vtkDataObject::ORIGIN())[axis], origin[axis]);
    EXPECT_DOUBLE_EQ(information->Get(vtkDataObject::SPACING())[axis], spacing[axis]);
    EXPECT_DOUBLE_EQ(filter->GetOutput()->GetOrigin()[axis], origin[axis]);
    EXPECT_DOUBLE_EQ(filter->GetOutput()->GetSpacing()[axis], spacing[axis]);
  }
  // Automatic again: what was published must go.
  filter->SetModelBounds(1.0, -1.0, 1.0, -1.0, 1.0, -1.0);
  EXPECT_FALSE(InformationOf(filter)->Has(vtkDataObject::ORIGIN()));
}

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, UnusableModelBoundsAreRefused)
{
  const double infinity = vtkMath::Inf();
  for (const double end : { 0.0, infinity })
  {
    vtkNew<vtkMeshSDF> filter;
    EventLog log(filter);
    filter->SetInputData(Sample::Icosphere(1));
    filter->SetSampleDimensions(8, 8, 8);
    filter->SetModelBounds(0.0, end, 0.0, 1.0, 0.0, 1.0);
    filter->Update();
    ASSERT_EQ(log.Errors.size(), 1u) << "end " << end;
    EXPECT_TRUE(IsOneSentence(log.Errors.front()));
    EXPECT_TRUE(IsInitialized(filter->GetOutput()));
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, OnlyABoxInvertedAlongAllAxesIsAutomatic)
{
  vtkNew<vtkMeshSDF> filter;
  EventLog log(filter);
  filter->SetInputData(Sample::Icosphere(1));
  filter->SetSampleDimensions(8, 8, 8);
  for (int inverted = 1; inverted < 8; ++inverted)
  {
    log.Clear();
    double ends[6];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double sign = (inverted >> axis & 1) ? -1.0 : 1.0;
      ends[2 * axis] = -2.0 * sign;
      ends[2 * axis + 1] = 2.0 * sign;
    }
    filter->SetModelBounds(ends);
    filter->Update();
    const bool isAutomatic = inverted == 7;
    ASSERT_EQ(log.Errors.size(), isAutomatic ? 0u : 1u) << "axes " << inverted;
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), isAutomatic ? 512 : 0);
    if (!isAutomatic)
    {
      EXPECT_TRUE(IsOneSentence(log.Errors.front()));
      EXPECT_NE(log.Errors.front().find("ModelBounds"), std::string::npos);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, SweepsNeedCubicCells)
{
  vtkNew<vtkMeshSDF> filter;
  EventLog log(filter);
  filter->SetInputData(Sample::Icosphere(1));
  filter->SetSampleDimensions(8, 8, 8);
  filter->SetModelBounds(-2.0, 2.0, -2.0, 2.0, -1.0, 1.0);
  filter->SetMethodToFastSweeping();
  filter->Update();
  ASSERT_EQ(log.Errors.size(), 1u);
  EXPECT_TRUE(IsOneSentence(log.Errors.front()));
  EXPECT_TRUE(IsInitialized(filter->GetOutput()));
}

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, CellsAreCubesAroundThePaddedBounds)
{
  vtkNew<vtkMeshSDF> filter;
  filter->SetInputData(Sample::Octahedron(3.0));
  filter->SetSampleDimensions(21, 31, 26);
  filter->SetPadding(0.25);
  filter->Update();
  const double* spacing = filter->GetOutput()->GetSpacing();
  // The padded side, 6 + 2 * 1.5, over the 20 cells of the shortest axis.
  EXPECT_NEAR(spacing[0], 9.0 / 20.0, 1e-12);
  EXPECT_EQ(spacing[0], spacing[1]);
  EXPECT_EQ(spacing[0], spacing[2]);
  const double* bounds = filter->GetOutput()->GetBounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(bounds[2 * axis] + bounds[2 * axis + 1], 0.0, 1e-12);
    EXPECT_GE(bounds[2 * axis + 1], 4.5 - 1e-12);
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, OneSampleAlongAnAxisIsASliceThroughTheMiddle)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    int dimensions[3] = { 25, 25, 25 };
    dimensions[axis] = 1;
    vtkNew<vtkMeshSDF> filter;
    filter->SetInputData(Sample::Icosphere(3));
    filter->SetSampleDimensions(dimensions);
    filter->Update();
    ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 625);
    for (vtkIdType i = 0; i < 625; ++i)
    {
      double p[3];
      filter->GetOutput()->GetPoint(i, p);
      ASSERT_NEAR(p[axis], 0.0, 1e-12);
      const double d = filter->GetOutput()->GetPointData()->GetScalars()->GetTuple1(i);
      ASSERT_NEAR(d, vtkMath::Norm(p) - 1.0, 0.01);
    }
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, OneSampleInAll)
{
  vtkNew<vtkMeshSDF> filter;
  filter->SetInputData(Sample::Box(1));
  filter->SetSampleDimensions(1, 1, 1);
  filter->Update();
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 1);
  EXPECT_NEAR(filter->GetOutput()->GetPointData()->GetScalars()->GetTuple1(0), -1.0, 1e-6);
}

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, AGridLargerThanMemoryIsRefusedInBytes)
{
  vtkNew<vtkMeshSDF> filter;
  EventLog log(filter);
  filter->SetInputData(Sample::Icosphere(0));
  filter->SetSampleDimensions(65536, 65536, 65536);
  filter->Update();
  ASSERT_EQ(log.Errors.size(), 1u);
  EXPECT_TRUE(IsOneSentence(log.Errors.front()));
  EXPECT_NE(log.Errors.front().find("281474976710656 samples"), std::string::npos);
  EXPECT_NE(log.Errors.front().find("bytes"), std::string::npos);
  EXPECT_TRUE(IsInitialized(filter->GetOutput()));
}

//------------------------------------------------------------------------------
TEST(MeshSDFGrid, APartOfAHugeGridIsComputed)
{
  vtkNew<vtkMeshSDF> filter;
  EventLog log(filter);
  filter->SetInputData(Sample::Icosphere(1));
  filter->SetMethodToBruteForce();
  filter->SetSampleDimensions(65536, 65536, 65536);
  int corner[6] = { 65533, 65535, 65533, 65535, 65533, 65535 };
  filter->UpdateExtent(corner);
  EXPECT_TRUE(log.Errors.empty());
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 27);
  double p[3];
  filter->GetOutput()->GetPoint(26, p);
  const double d = filter->GetOutput()->GetPointData()->GetScalars()->GetTuple1(26);
  EXPECT_NEAR(d, vtkMath::Norm(p) - 1.0, 0.1);
}

} // namespace
