// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkMeshSDF: which side a sample is on, and what is said of it.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

//------------------------------------------------------------------------------
TEST(MeshSDFSign, FieldDataSayWhichSignAndWhy)
{
  const auto closed = Distance(Sample::Icosphere(2), 8);
  EXPECT_EQ(FieldValue(closed, "SignMethod"), vtkMeshSDF::PSEUDONORMAL);
  EXPECT_TRUE(IsOneSentence(FieldText(closed, "SignReason")));
  const auto open = Distance(
    Sample::KeepPolygons(Sample::Icosphere(2), [](vtkIdType number) { return number > 5; }), 8);
  EXPECT_EQ(FieldValue(open, "SignMethod"), vtkMeshSDF::WINDING_NUMBER);
  EXPECT_TRUE(IsOneSentence(FieldText(open, "SignReason")));
  const auto points = Distance(Sample::PointsOf(Sample::Icosphere(2)), 8);
  EXPECT_EQ(FieldValue(points, "SignMethod"), vtkMeshSDF::UNSIGNED);
  EXPECT_TRUE(IsOneSentence(FieldText(points, "SignReason")));
  const auto chosen =
    Distance(Sample::Icosphere(2), 16, [](vtkMeshSDF* filter) { filter->SetSignToFloodFill(); });
  EXPECT_EQ(FieldValue(chosen, "SignMethod"), vtkMeshSDF::FLOOD_FILL);
}

//------------------------------------------------------------------------------
class MeshSDFSignMethod : public testing::TestWithParam<int>
{
};

TEST_P(MeshSDFSignMethod, AgreesOnAClosedSurface)
{
  const auto image = Distance(
    Sample::Read("torus.ply"), 32, [](vtkMeshSDF* filter) { filter->SetSign(GetParam()); });
  vtkDataArray* distance = image->GetPointData()->GetScalars();
  EXPECT_EQ(FieldValue(image, "SignMethod"), GetParam());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    const double exact = std::hypot(std::hypot(p[0], p[1]) - 1.0, p[2]) - 0.4;
    if (std::abs(exact) > 0.05)
    {
      const bool isInside = GetParam() != vtkMeshSDF::UNSIGNED && exact < 0.0;
      ASSERT_EQ(distance->GetTuple1(i) < 0.0, isInside) << exact;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, MeshSDFSignMethod,
  testing::Values(vtkMeshSDF::FLOOD_FILL, vtkMeshSDF::WINDING_NUMBER, vtkMeshSDF::PSEUDONORMAL,
    vtkMeshSDF::UNSIGNED));

} // namespace
