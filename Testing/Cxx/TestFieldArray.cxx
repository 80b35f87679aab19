// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Which array of the image is vtkSurfaceEvolution's field.

#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"

#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkSurfaceEvolution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace
{

constexpr int OfPoints = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int OfCells = vtkDataObject::FIELD_ASSOCIATION_CELLS;

using Image = vtkSmartPointer<vtkImageData>;

//------------------------------------------------------------------------------
void AddDistance(vtkDataSetAttributes* data, const char* name, double radius, vtkIdType count,
  const std::function<void(vtkIdType, double[3])>& place)
{
  vtkNew<vtkDoubleArray> distance;
  distance->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    place(i, p);
    distance->InsertNextValue(std::hypot(p[0], p[1], p[2]) - radius);
  }
  data->AddArray(distance);
}

//------------------------------------------------------------------------------
/// Distances to spheres: of radius 1 the active scalars, of 0.8 another array, of 0.6 of the cells.
Image ThreeSpheres()
{
  const Image image = Sample::SphereImage(33, 2.0, 1.0);
  AddDistance(image->GetPointData(), "Smaller", 0.8, image->GetNumberOfPoints(),
    [&](vtkIdType i, double p[3]) { image->GetPoint(i, p); });
  AddDistance(image->GetCellData(), "Smallest", 0.6, image->GetNumberOfCells(),
    [&](vtkIdType i, double p[3])
    {
      double bounds[6];
      image->GetCellBounds(i, bounds);
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] = 0.5 * (bounds[2 * axis] + bounds[2 * axis + 1]);
      }
    });
  return image;
}

//------------------------------------------------------------------------------
void SetUpOnto(vtkSurfaceEvolution* filter, vtkImageData* image)
{
  filter->SetInputData(0, Sample::Icosphere(3, 1.5));
  filter->SetInputData(1, image);
  filter->SetRemeshingToOff();
  filter->SetTimeStep(0.1);
  filter->SetNumberOfSteps(60);
  filter->SetCurvatureSpeed(0.001);
}

//------------------------------------------------------------------------------
double RadiusOf(vtkSurfaceEvolution* filter)
{
  filter->Update();
  const Range range = DistanceFromOrigin(filter->GetOutput());
  EXPECT_NEAR(range.Smallest, range.Largest, 0.02);
  return range.Largest;
}

//------------------------------------------------------------------------------
TEST(FieldArray, IsTheActiveScalarsUnlessAnotherIsChosen)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpOnto(filter, ThreeSpheres());
  EXPECT_NEAR(RadiusOf(filter), 1.0, 0.015);
  filter->SetInputArrayToProcess(0, 1, 0, OfPoints, "Smaller");
  EXPECT_NEAR(RadiusOf(filter), 0.8, 0.015);
  filter->SetInputArrayToProcess(0, 1, 0, OfPoints, ""); // as ParaView says it
  EXPECT_NEAR(RadiusOf(filter), 1.0, 0.015);
  filter->SetInputArrayToProcess(
    0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, "Smallest");
  EXPECT_NEAR(RadiusOf(filter), 0.6, 0.015);
  filter->SetInputArrayToProcess(0, 1, 0, OfPoints, vtkDataSetAttributes::SCALARS);
  EXPECT_NEAR(RadiusOf(filter), 1.0, 0.015);
}

//------------------------------------------------------------------------------
TEST(FieldArray, ItIsReadOnceForAllTimes)
{
  const Image image = ThreeSpheres();
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpOnto(filter, image);
  filter->SetInputArrayToProcess(0, 1, 0, OfCells, "Smallest");
  for (const int step : { 60, 0, 30 })
  {
    filter->UpdateTimeStep(0.1 * step);
  }
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
  image->GetPointData()->SetActiveScalars("Smaller"); // which is not the one that counts
  image->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 1);
  image->GetCellData()->GetArray("Smallest")->SetTuple1(0, 1.0);
  image->GetCellData()->GetArray("Smallest")->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetNumberOfSolves(), 2);
}

//------------------------------------------------------------------------------
TEST(FieldArray, CellsAreSamplesAtTheirMiddles)
{
  // In an image that is turned and not centered, so that a shift of half a cell would show.
  const Image image = ThreeSpheres();
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpOnto(filter, image);
  filter->SetInputArrayToProcess(0, 1, 0, OfCells, "Smallest");
  EXPECT_NEAR(RadiusOf(filter), 0.6, 0.015);
  filter->SetInputArrayToProcess(0, 1, 0, OfPoints, "");
  image->GetCellData()->SetActiveScalars("Smallest");
  EXPECT_NEAR(RadiusOf(filter), 1.0, 0.015); // points come first
  image->GetPointData()->SetActiveScalars(nullptr);
  EXPECT_NEAR(RadiusOf(filter), 0.6, 0.015);
  image->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
  image->SetOrigin(2.0, -2.0, -2.0); // turned about it, the samples are where they were
  EXPECT_NEAR(RadiusOf(filter), 0.6, 0.015);
}

//------------------------------------------------------------------------------
void ExpectRefusedChoice(
  vtkImageData* image, int port, int where, const char* name, const std::string& words)
{
  vtkNew<vtkSurfaceEvolution> filter;
  SetUpOnto(filter, image);
  filter->SetInputArrayToProcess(0, port, 0, where, name);
  ExpectRefusalOf(filter, words);
}

//------------------------------------------------------------------------------
TEST(FieldArray, WhatCannotBeAFieldIsRefusedByName)
{
  const Image image = ThreeSpheres();
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Velocity");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(image->GetNumberOfPoints());
  vectors->Fill(1.0);
  image->GetPointData()->AddArray(vectors);
  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  names->SetNumberOfValues(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(names);
  ExpectRefusedChoice(image, 1, OfPoints, "Smallest", "no point array \"Smallest\"");
  ExpectRefusedChoice(image, 1, OfPoints, "None", "\"Smallest\" (cells)");
  ExpectRefusedChoice(image, 1, OfCells, "Smaller", "no cell array \"Smaller\"");
  ExpectRefusedChoice(image, 1, OfPoints, "Velocity", "3 components");
  ExpectRefusedChoice(image, 1, OfPoints, "Names", "no numbers");
  ExpectRefusedChoice(image, 0, OfPoints, "Smaller", "port 0");
  image->GetPointData()->SetActiveScalars(nullptr);
  ExpectRefusedChoice(image, 1, OfPoints, "", "no active Scalars");
}

//------------------------------------------------------------------------------
TEST(FieldArray, ArraysOfAnotherLengthAreRefused)
{
  const Image image = ThreeSpheres();
  image->GetCellData()->GetArray("Smallest")->SetNumberOfTuples(image->GetNumberOfPoints());
  ExpectRefusedChoice(image, 1, OfCells, "Smallest", "");
}

} // namespace
