// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution: fields in images of any kind.

#include "DataChecks.h"
#include "EventLog.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;

//------------------------------------------------------------------------------
/// The distances to a sphere of radius 100, rounded, as another type: as far as that goes.
Image OfType(int type)
{
  const Image image = Sample::SphereImage(25, 180.0, 100.0);
  vtkDataArray* distances = image->GetPointData()->GetScalars();
  const auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  values->SetNumberOfTuples(distances->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple1(i,
      std::clamp(
        std::round(distances->GetTuple1(i)), values->GetDataTypeMin(), values->GetDataTypeMax()));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

//------------------------------------------------------------------------------
/// The same samples with other numbers.
Image Renumbered()
{
  const Image image = Sample::SphereImage(25, 180.0, 100.0);
  image->SetOrigin(-180.0 + 7 * 15.0, -180.0 - 3 * 15.0, -180.0 - 100 * 15.0);
  image->SetExtent(-7, 17, 3, 27, 100, 124);
  return image;
}

//------------------------------------------------------------------------------
Image WithFlatCells()
{
  auto image = Image::New();
  image->SetDimensions(37, 25, 13);
  image->SetOrigin(-180.0, -180.0, -180.0);
  image->SetSpacing(10.0, 15.0, 30.0);
  vtkNew<vtkDoubleArray> distance;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    distance->InsertNextValue(std::hypot(p[0], p[1], p[2]) - 100.0);
  }
  image->GetPointData()->SetScalars(distance);
  return image;
}

struct ImageCase
{
  const char* Name;
  std::function<Image()> Make;
  double Tolerance; ///< of the radius, which is 100
};

class FieldImages : public testing::TestWithParam<ImageCase>
{
};

TEST_P(FieldImages, DrawTheSurfaceOntoTheirZeroSet)
{
  vtkNew<vtkSurfaceEvolution> filter;
  EventLog log(filter);
  SetUpAttraction(filter, Sample::Icosphere(2, 150.0));
  filter->SetInputData(1, GetParam().Make());
  filter->Update();
  ASSERT_TRUE(log.Errors.empty()) << log.Errors.front();
  EXPECT_TRUE(IsFinite(filter->GetOutput()));
  const Range distance = DistanceFromOrigin(filter->GetOutput());
  EXPECT_NEAR(distance.Smallest, 100.0, GetParam().Tolerance);
  EXPECT_NEAR(distance.Largest, 100.0, GetParam().Tolerance);
}

INSTANTIATE_TEST_SUITE_P(All, FieldImages,
  testing::Values(ImageCase{ "Double", []() { return OfType(VTK_DOUBLE); }, 2.0 },
    ImageCase{ "Short", []() { return OfType(VTK_SHORT); }, 2.0 },
    ImageCase{ "SignedChar", []() { return OfType(VTK_SIGNED_CHAR); }, 2.5 },
    ImageCase{ "OtherNumbers", Renumbered, 2.0 }, ImageCase{ "FlatCells", WithFlatCells, 2.0 }),
  [](const testing::TestParamInfo<ImageCase>& info) { return info.param.Name; });

//------------------------------------------------------------------------------
/// An evolution along this image ends with one sentence that has these words.
void ExpectSentence(vtkSurfaceEvolution* filter, vtkImageData* image, const char* words)
{
  EventLog log(filter);
  SetUpAttraction(filter, Sample::Icosphere(2, 1.5));
  filter->SetInputData(1, image);
  filter->Update();
  ASSERT_EQ(log.Errors.size(), 1u);
  EXPECT_TRUE(IsOneSentence(log.Errors.front()));
  EXPECT_NE(log.Errors.front().find(words), std::string::npos);
}

//------------------------------------------------------------------------------
TEST(FieldImage, ArraysThatAreNotActiveAreRefusedWithTheirNames)
{
  const Image image = Sample::SphereImage(9, 2.0, 1.0);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("Cells");
  cells->SetNumberOfTuples(image->GetNumberOfCells());
  cells->Fill(1.0);
  image->GetPointData()->Initialize();
  image->GetCellData()->AddArray(cells);
  vtkNew<vtkSurfaceEvolution> filter;
  ExpectSentence(filter, image, "choose one of its arrays: \"Cells\" (cells)");
  EXPECT_TRUE(IsInitialized(filter->GetOutput()));
}

//------------------------------------------------------------------------------
TEST(FieldImage, ValuesThatAreNoDistancesAreRefused)
{
  const Image image = Sample::SphereImage(9, 2.0, 1.0);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple1(i, 100.0 * values->GetTuple1(i));
  }
  vtkNew<vtkSurfaceEvolution> filter;
  ExpectSentence(filter, image, "expected a signed distance, which changes by 1");
  EXPECT_TRUE(IsInitialized(filter->GetOutput()));
}

//------------------------------------------------------------------------------
TEST(FieldImage, AShearIsRefusedWithItsMatrix)
{
  const Image image = Sample::SphereImage(9, 2.0, 1.0);
  image->SetDirectionMatrix(1, 0.25, 0, 0, 1, 0, 0, 0, 1);
  vtkNew<vtkSurfaceEvolution> filter;
  ExpectSentence(filter, image, "direction matrix");
}

//------------------------------------------------------------------------------
TEST(FieldImage, SpacingsThatAreNotPositiveAreRefusedWithTheWayOut)
{
  for (const double spacing : { 0.0, -0.1 })
  {
    const Image image = Sample::SphereImage(9, 2.0, 1.0);
    image->SetSpacing(0.1, 0.1, spacing);
    vtkNew<vtkSurfaceEvolution> filter;
    ExpectSentence(filter, image, "flip it by its direction matrix");
  }
}

} // namespace
