// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkMeshSDF: what does not count, and what is one clear error.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "EventLog.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"
#include "SelfCrossingSurfaces.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

using Filter = vtkSmartPointer<vtkMeshSDF>;

//------------------------------------------------------------------------------
Filter MakeFilter(vtkPolyData* input, int method = vtkMeshSDF::CLOSEST_POINT)
{
  auto filter = Filter::New();
  filter->SetInputData(input);
  filter->SetSampleDimensions(11, 11, 11);
  filter->SetMethod(method);
  return filter;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DistanceBy(vtkPolyData* input, int method = vtkMeshSDF::CLOSEST_POINT)
{
  const Filter filter = MakeFilter(input, method);
  EventLog log(filter);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
/// One cell of the ids.
vtkNew<vtkCellArray> Cell(const Sample::Polygon& ids)
{
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  return cells;
}

//------------------------------------------------------------------------------
class MeshSDFMethod : public testing::TestWithParam<int>
{
};

TEST_P(MeshSDFMethod, MeasuresFromThePointsOfLines)
{
  const std::vector<Sample::Point> points = { { -1, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 } };
  const auto line = Sample::Make(points, {});
  line->SetLines(Cell({ 0, 1, 2 }));
  const auto image = DistanceBy(line, GetParam());
  EXPECT_TRUE(SameImage(DistanceBy(Sample::Make(points, {}), GetParam()), image));
  EXPECT_EQ(FieldValue(image, "SignMethod"), vtkMeshSDF::UNSIGNED);
}

TEST_P(MeshSDFMethod, LeavesVerticesAndLinesBesideFacesOut)
{
  std::vector<Sample::Point> points = Sample::CoordinatesOf(Sample::Icosphere(2));
  const auto number = static_cast<vtkIdType>(points.size());
  points.insert(points.end(), { { 5, 0, 0 }, { 0, 7, 0 } });
  const auto surface = Sample::Make(points, Sample::PolygonsOf(Sample::Icosphere(2)));
  surface->SetVerts(Cell({ number }));
  surface->SetLines(Cell({ number, number + 1 }));
  EXPECT_TRUE(
    SameImage(DistanceBy(Sample::Icosphere(2), GetParam()), DistanceBy(surface, GetParam())));
}

TEST_P(MeshSDFMethod, LeavesAPointOutThatIsNotANumberAndThatNothingUses)
{
  std::vector<Sample::Point> points = Sample::CoordinatesOf(Sample::Icosphere(2));
  points.push_back({ vtkMath::Nan(), vtkMath::Inf(), 0 });
  const auto surface = Sample::Make(points, Sample::PolygonsOf(Sample::Icosphere(2)));
  EXPECT_TRUE(
    SameImage(DistanceBy(Sample::Icosphere(2), GetParam()), DistanceBy(surface, GetParam())));
}

TEST_P(MeshSDFMethod, HasAFiniteDistanceToAKleinBottle)
{
  const auto image = DistanceBy(Sample::KleinBottle(30, 16), GetParam());
  EXPECT_TRUE(IsFinite(image));
  EXPECT_EQ(FieldValue(image, "SignMethod"), vtkMeshSDF::WINDING_NUMBER);
  EXPECT_NE(FieldText(image, "SignReason").find("one-sided"), std::string::npos);
}

TEST_P(MeshSDFMethod, RefusesWhatIsDamaged)
{
  const auto sphere = Sample::Icosphere(1);
  const vtkIdType count = sphere->GetNumberOfPoints();
  for (const vtkIdType wrong : { vtkIdType(-1), count, vtkIdType(1) << 40 })
  {
    const auto vertices = Sample::PointsOf(sphere);
    vertices->SetVerts(Cell({ wrong }));
    ExpectRefusalOf(MakeFilter(vertices, GetParam()), "refers to point " + std::to_string(wrong));
    const auto polygons = Sample::Make(Sample::CoordinatesOf(sphere), { { 0, 1, wrong } });
    ExpectRefusalOf(MakeFilter(polygons, GetParam()), "refers to point " + std::to_string(wrong));
  }
  const auto points = Sample::Make({ { 0, 0, 0 }, { vtkMath::Nan(), 0, 0 } }, {});
  ExpectRefusalOf(MakeFilter(points, GetParam()), "nan");
  const auto nowhere = Sample::Make({ { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } }, { { 0, 1, 2 } });
  ExpectRefusalOf(MakeFilter(nowhere, GetParam()), "three different corners");
}

TEST_P(MeshSDFMethod, RefusesSizesThatFloatsCannotHold)
{
  for (const double size : { 1e-50, 1e-32, 1e32, 1e39, 1e200 })
  {
    ExpectRefusalOf(MakeFilter(Sample::Icosphere(1, size), GetParam()), "single precision");
  }
  for (const double size : { 1e-30, 1e30 })
  {
    const auto image = DistanceBy(Sample::Icosphere(1, size), GetParam());
    EXPECT_TRUE(IsFinite(image));
    EXPECT_NEAR(image->GetPointData()->GetScalars()->GetTuple1(665) / size, -0.88, 0.12);
  }
}

TEST_P(MeshSDFMethod, RefusesModelBoundsThatFloatsCannotHold)
{
  for (const double end : { 1e38, 1e39, 1e300, 1e-38, 1e-300 })
  {
    const Filter filter = MakeFilter(Sample::Icosphere(1), GetParam());
    filter->SetModelBounds(-3 * end, 3 * end, -3 * end, 3 * end, -3 * end, 3 * end);
    ExpectRefusalOf(filter, "single precision");
  }
  const Filter filter = MakeFilter(Sample::Icosphere(1), GetParam());
  filter->SetModelBounds(-1e37, 1e37, -1e37, 1e37, -1e37, 1e37);
  filter->Update();
  EXPECT_TRUE(IsFinite(filter->GetOutput()));
  EXPECT_GT(filter->GetOutput()->GetPointData()->GetScalars()->GetTuple1(0), 1.7e37);
}

INSTANTIATE_TEST_SUITE_P(All, MeshSDFMethod,
  testing::Values(vtkMeshSDF::CLOSEST_POINT, vtkMeshSDF::FAST_SWEEPING, vtkMeshSDF::BRUTE_FORCE),
  NameOfMethod);

//------------------------------------------------------------------------------
TEST(MeshSDFNothing, IsAnEmptyImage)
{
  const auto nothing = vtkSmartPointer<vtkPolyData>::New();
  // Cells without points: there is nothing they could refer to.
  const auto noPoints = vtkSmartPointer<vtkPolyData>::New();
  noPoints->SetPolys(Cell({ 0, 1, 2 }));
  for (const auto& input : { nothing, noPoints })
  {
    EXPECT_TRUE(IsInitialized(DistanceBy(input)));
  }
}

//------------------------------------------------------------------------------
TEST(MeshSDFNothing, OfNoInputIsAnErrorOfThePipeline)
{
  const Filter filter = MakeFilter(nullptr);
  EventLog log(filter);
  filter->Update();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_TRUE(IsInitialized(filter->GetOutput()));
}

} // namespace
