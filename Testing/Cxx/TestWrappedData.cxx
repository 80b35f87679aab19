// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// The data of vtkShrinkWrap's input on its output.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "DressedSurfaces.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using Surface = Sample::Surface;

//------------------------------------------------------------------------------
Surface Wrapped(vtkPolyData* surface, const std::function<void(vtkShrinkWrap*)>& setUp = {})
{
  vtkNew<vtkShrinkWrap> filter;
  SetUpCoarsely(filter, surface);
  filter->SetNumberOfSteps(0);
  if (setUp)
  {
    setUp(filter);
  }
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
TEST(WrappedData, ASphereHasTheDataOfTheClosestPlaces)
{
  const Surface output = Wrapped(Sample::Dressed(Sample::Icosphere(3)));
  // The input's edges are .15 long, so its middles are .003 below the sphere; cells are not split.
  EXPECT_TRUE(HasDataOfDirections(output, 0.02, 0.15));
  EXPECT_TRUE(HasCellDataOfDirections(output, 0.15));
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Height");
  EXPECT_FALSE(output->GetPointData()->HasArray("Number"));
  EXPECT_FALSE(output->GetPointData()->HasArray("Pedigree"));
  EXPECT_FALSE(output->GetPointData()->HasArray("vtkGhostType"));
  EXPECT_FALSE(output->GetCellData()->HasArray("CellNumber"));
  EXPECT_EQ(FieldText(output, "Patient"), "Anna");
}

//------------------------------------------------------------------------------
TEST(WrappedData, LinearDataOfABoxAreExactOnIt)
{
  // On flat faces, cut in any triangles, interpolation reproduces what is linear.
  const Surface box = Sample::Soup(Sample::Triangulated(Sample::Box(3)));
  vtkNew<vtkDoubleArray> linear;
  linear->SetName("Linear");
  const auto value = [](const double p[3]) { return 1.0 + p[0] - 2.0 * p[1] + 3.0 * p[2]; };
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    linear->InsertNextValue(value(box->GetPoint(i)));
  }
  box->GetPointData()->AddArray(linear);
  const Surface output = Wrapped(box);
  const double slope = std::sqrt(14.0);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(output->GetPointData()->GetArray("Linear")->GetTuple1(i),
      value(output->GetPoint(i)), slope * FieldValue(output, "MaxDistance") + 1e-6);
  }
}

//------------------------------------------------------------------------------
TEST(WrappedData, FacesOfABoxNameTheTrianglesOnThem)
{
  const Surface box = Sample::Box(1);
  vtkNew<vtkIntArray> number;
  number->SetName("Face");
  for (int i = 0; i < 6; ++i)
  {
    number->InsertNextValue(i);
  }
  box->GetCellData()->SetScalars(number);
  const Surface output = Wrapped(box);
  int counts[6] = { 0, 0, 0, 0, 0, 0 };
  vtkDataArray* faces = output->GetCellData()->GetScalars();
  ASSERT_TRUE(faces);
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    ++counts[static_cast<int>(faces->GetTuple1(i))];
  }
  for (const int count : counts)
  {
    EXPECT_NEAR(count, output->GetNumberOfCells() / 6.0, 0.1 * output->GetNumberOfCells() / 6.0);
  }
}

//------------------------------------------------------------------------------
TEST(WrappedData, PointsGiveTheDataOfTheClosestOne)
{
  const Surface dressed = Sample::Dressed(Sample::Icosphere(4));
  const Surface points = Surface::New();
  points->SetPoints(dressed->GetPoints());
  points->GetPointData()->ShallowCopy(dressed->GetPointData());
  EXPECT_TRUE(HasDataOfDirections(Wrapped(points), 0.06, 0.06)); // they are .07 from each other
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = points->GetNumberOfPoints() - 1; i >= 0; --i)
  {
    vertices->InsertNextCell(1, &i);
  }
  points->SetVerts(vertices);
  vtkNew<vtkDoubleArray> heights; // of the vertex cells, which are in another order
  heights->SetName("CellHeight");
  for (vtkIdType i = points->GetNumberOfPoints() - 1; i >= 0; --i)
  {
    heights->InsertNextValue(points->GetPoint(i)[2]);
  }
  points->GetCellData()->AddArray(heights);
  const Surface output = Wrapped(points);
  EXPECT_TRUE(HasDataOfDirections(output, 0.06, 0.06));
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    double bounds[6];
    output->GetCellBounds(i, bounds);
    const double found = output->GetCellData()->GetArray("CellHeight")->GetTuple1(i);
    ASSERT_NEAR(found, 0.5 * (bounds[4] + bounds[5]), 0.15);
  }
}

//------------------------------------------------------------------------------
TEST(WrappedData, FacesThatAreLeftOutGiveNone)
{
  const Surface surface = Sample::Icosphere(3);
  surface->GetPoints()->InsertNextPoint(std::nan(""), 0.0, 0.0);
  vtkNew<vtkCellArray> polygons;
  const vtkIdType broken[3] = { 0, 1, surface->GetNumberOfPoints() - 1 };
  polygons->InsertNextCell(3, broken);
  polygons->Append(surface->GetPolys());
  surface->SetPolys(polygons);
  const Surface dressed = Sample::Dressed(surface);
  const Surface output =
    Wrapped(dressed, [](vtkShrinkWrap* filter) { filter->SetTargetEdgeLength(0.12); });
  EXPECT_TRUE(HasDataOfDirections(output, 0.02, 0.15));
  EXPECT_TRUE(HasCellDataOfDirections(output, 0.15));
}

//------------------------------------------------------------------------------
TEST(WrappedData, TheyCanBeLeftOut)
{
  const Surface dressed = Sample::Dressed(Sample::Icosphere(2));
  const Surface output = Wrapped(dressed,
    [](vtkShrinkWrap* filter)
    {
      filter->PassPointDataOff();
      filter->PassCellDataOff();
    });
  EXPECT_FALSE(output->GetPointData()->HasArray("Height"));
  EXPECT_FALSE(output->GetCellData()->HasArray("Side"));
}

//------------------------------------------------------------------------------
TEST(WrappedData, EveryStepHasThem)
{
  vtkNew<vtkShrinkWrap> filter;
  SetUpCoarsely(filter, Sample::Dressed(Sample::Icosphere(3)));
  filter->OutputStepsOn();
  filter->SetNumberOfSteps(3);
  filter->UpdateInformation();
  const double* times =
    filter->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  for (const double time : { times[0], times[2], times[3] })
  {
    filter->UpdateTimeStep(time);
    EXPECT_TRUE(HasDataOfDirections(filter->GetOutput(), 0.02, 0.15)) << time;
  }
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
}

} // namespace
