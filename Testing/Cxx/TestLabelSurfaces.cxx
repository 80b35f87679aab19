// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkLabelSurfaces in pipelines: arrays, fields, composition, and what it says of bad images.

#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "LabelImages.h"
#include "SurfaceMeasures.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLabelSurfaces.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

//------------------------------------------------------------------------------
TEST(LabelSurfaces, EveryLabelHasAClosedSurface)
{
  const auto filter = FilterOf(Halves(), -1.0);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_TRUE(IsFinite(output));
  EXPECT_EQ(
    ArrayNames(output->GetCellData()), (std::vector<std::string>{ "Label", "NeighborLabel" }));
  EXPECT_EQ(output->GetCellData()->GetScalars()->GetDataType(), VTK_SHORT);
  vtkFieldData* field = output->GetFieldData();
  for (vtkIdType l = 0; l < 2; ++l)
  {
    EXPECT_EQ(field->GetArray("LabelValue")->GetComponent(l, 0), l == 0 ? 5.0 : 9.0);
    const auto surface = SurfaceOf(filter, l == 0 ? 5.0 : 9.0);
    const double wanted = field->GetArray("VoxelVolume")->GetComponent(l, 0);
    EXPECT_EQ(CountBadEdges(surface), 0);
    EXPECT_NEAR(VolumeOf(surface), wanted, 1e-4 * wanted);
    EXPECT_NEAR(field->GetArray("Volume")->GetComponent(l, 0), wanted, 1e-5 * wanted);
  }
}

//------------------------------------------------------------------------------
TEST(LabelSurfaces, LiesWhereTheImageIs)
{
  const Image image = Halves();
  const auto filter = FilterOf(image, -1.0);
  filter->Update();
  double center[3];
  image->GetCenter(center);
  const Range range = RangeOverPoints(filter->GetOutput(1),
    [&](const double p[3])
    {
      const double d[3] = { p[0] - center[0] - 0.1, p[1] - center[1] - 0.07,
        p[2] - center[2] - 0.03 };
      return std::hypot(d[0], d[1], d[2]);
    });
  EXPECT_NEAR(range.Largest, 5.5, 0.4);
}

//------------------------------------------------------------------------------
TEST(LabelSurfaces, InterfacesHaveTheLabelsOfBothSides)
{
  const auto filter = FilterOf(Halves(), -1.0);
  filter->Update();
  vtkPolyData* interfaces = filter->GetOutput(1);
  vtkDataArray* sides = interfaces->GetCellData()->GetArray("BoundaryLabels");
  ASSERT_NE(sides, nullptr);
  ASSERT_EQ(sides->GetNumberOfComponents(), 2);
  vtkIdType shared = 0;
  for (vtkIdType i = 0; i < sides->GetNumberOfTuples(); ++i)
  {
    EXPECT_NE(sides->GetComponent(i, 0), sides->GetComponent(i, 1));
    shared += sides->GetComponent(i, 0) > 0 && sides->GetComponent(i, 1) > 0 ? 1 : 0;
  }
  EXPECT_GT(shared, 100);
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), interfaces->GetNumberOfCells() + shared);
}

//------------------------------------------------------------------------------
TEST(LabelSurfaces, ChosenLabelsAlone)
{
  const auto filter = FilterOf(Halves(), -1.0);
  filter->AddLabel(9.0);
  filter->AddLabel(9.0);
  ASSERT_EQ(filter->GetNumberOfLabels(), 1);
  EXPECT_EQ(filter->GetLabel(0), 9.0);
  EXPECT_EQ(filter->GetLabel(7), 0.0);
  filter->Update();
  double range[2];
  filter->GetOutput()->GetCellData()->GetArray("Label")->GetRange(range);
  EXPECT_EQ(range[0], 9.0);
  filter->GetOutput()->GetCellData()->GetArray("NeighborLabel")->GetRange(range);
  EXPECT_EQ(range[1], -1.0);
  filter->RemoveAllLabels();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("LabelValue")->GetNumberOfTuples(), 2);
}

//------------------------------------------------------------------------------
TEST(LabelSurfaces, ABackgroundThatTheImageCannotHaveIsWritten)
{
  const auto filter = FilterOf(Ball(), 1e6);
  filter->Update();
  vtkDataArray* neighbors = filter->GetOutput()->GetCellData()->GetArray("NeighborLabel");
  EXPECT_EQ(neighbors->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(neighbors->GetRange()[1], 1e6);
}

//------------------------------------------------------------------------------
TEST(LabelSurfaces, SaysWhatIsWrong)
{
  ExpectRefusalOf(
    FilterOf(LabelImage(vtkNew<vtkFloatArray>(), [](double x, double, double) { return x; })),
    "expected labels");
  const Image noise = LabelImage(vtkNew<vtkShortArray>(),
    [](double x, double y, double z) { return std::floor(500.0 * std::sin(99.0 * x + y * z)); });
  ExpectRefusalOf(FilterOf(noise), "neighbouring voxels differ");
  const auto chosen = FilterOf(Halves());
  chosen->AddLabel(7.0);
  ExpectRefusalOf(chosen, "none of the chosen labels 7");
  const Image slice = Halves();
  slice->SetExtent(0, 31, 0, 447, 0, 0);
  ExpectRefusalOf(FilterOf(slice), "32 x 448 x 1");
  const Image flat = Halves();
  flat->SetSpacing(1.0, 0.0, 1.0);
  ExpectRefusalOf(FilterOf(flat), "(1, 0, 1)");
  const Image unnamed = Halves();
  unnamed->GetPointData()->SetActiveScalars(nullptr);
  ExpectRefusalOf(FilterOf(unnamed), "The image has no active");
}

//------------------------------------------------------------------------------
TEST(LabelSurfaces, OfNothingIsNothing)
{
  const auto filter = FilterOf(Image::New());
  EventLog log(filter);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  const Image empty =
    LabelImage(vtkNew<vtkShortArray>(), [](double, double, double) { return 0.0; });
  filter->SetInputData(empty);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
TEST(LabelSurfaces, MirroredImagesHaveSurfacesThatPointOutwards)
{
  const Image image = Halves();
  image->SetDirectionMatrix(0.0, -1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
  const auto filter = FilterOf(image, -1.0);
  filter->Update();
  const auto surface = SurfaceOf(filter, 5.0);
  const double wanted =
    filter->GetOutput()->GetFieldData()->GetArray("VoxelVolume")->GetComponent(0, 0);
  EXPECT_NEAR(VolumeOf(surface), wanted, 1e-4 * wanted);
  image->SetDirectionMatrix(1.0, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
  ExpectRefusalOf(FilterOf(image, -1.0));
}

//------------------------------------------------------------------------------
TEST(LabelSurfaces, StopsWhenAsked)
{
  const auto filter = FilterOf(Halves(), -1.0);
  EventLog log(filter);
  filter->SetAbortExecute(1);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_TRUE(IsInitialized(filter->GetOutput()));
}
