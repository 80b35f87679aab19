// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkMeshSDF: parts of the grid are those of the whole.

#include "FilterRuns.h"
#include "SampleSurfaces.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
struct PartCase
{
  int Method;
  int Sign;
  double Sigma;
  double Tolerance; ///< in cells
};

class MeshSDFParts : public testing::TestWithParam<PartCase>
{
protected:
  /// A fresh filter: VTK answers a smaller extent after a larger one from the old data.
  vtkSmartPointer<vtkImageData> Part(int extent[6])
  {
    vtkNew<vtkMeshSDF> filter;
    filter->SetInputData(Sample::Read("bunny.ply"));
    filter->SetSampleDimensions(33, 30, 28);
    filter->SetMethod(GetParam().Method);
    filter->SetSign(GetParam().Sign);
    filter->SetSmoothingSigma(GetParam().Sigma);
    EXPECT_TRUE(InformationOf(filter)->Has(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT()));
    filter->UpdateExtent(extent);
    return filter->GetOutput();
  }
};

TEST_P(MeshSDFParts, EqualTheWhole)
{
  int everything[6] = { 0, 32, 0, 29, 0, 27 };
  const auto whole = this->Part(everything);
  const double tolerance = GetParam().Tolerance * whole->GetSpacing()[0];
  // Halves, one sample, and a corner with no surface in it.
  int parts[4][6] = { { 0, 16, 0, 29, 0, 27 }, { 17, 32, 0, 29, 0, 27 }, { 9, 9, 20, 20, 3, 3 },
    { 28, 32, 24, 29, 0, 5 } };
  for (auto& extent : parts)
  {
    const auto part = this->Part(extent);
    int actual[6];
    part->GetExtent(actual);
    ASSERT_TRUE(std::equal(extent, extent + 6, actual));
    ASSERT_TRUE(std::equal(part->GetOrigin(), part->GetOrigin() + 3, whole->GetOrigin()));
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      double p[3];
      part->GetPoint(i, p);
      const double expected = whole->GetPointData()->GetScalars()->GetTuple1(whole->FindPoint(p));
      ASSERT_NEAR(part->GetPointData()->GetScalars()->GetTuple1(i), expected, tolerance);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(MethodsAndSigns, MeshSDFParts,
  testing::Values(PartCase{ vtkMeshSDF::BRUTE_FORCE, vtkMeshSDF::AUTOMATIC, 0.0, 0.0 },
    PartCase{ vtkMeshSDF::BRUTE_FORCE, vtkMeshSDF::WINDING_NUMBER, 0.0, 0.0 },
    PartCase{ vtkMeshSDF::BRUTE_FORCE, vtkMeshSDF::AUTOMATIC, 1.0, 1e-5 },
    PartCase{ vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::PSEUDONORMAL, 0.0, 0.0 },
    PartCase{ vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::UNSIGNED, 0.0, 0.0 },
    PartCase{ vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::FLOOD_FILL, 0.0, 0.0 },
    PartCase{ vtkMeshSDF::FAST_SWEEPING, vtkMeshSDF::AUTOMATIC, 0.0, 0.0 }));

} // namespace
