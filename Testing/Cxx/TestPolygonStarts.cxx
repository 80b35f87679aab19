// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Polygons that are neither flat nor convex, with corners in a row, alone, or in loops of three.

#include "ChangedSurfaces.h"
#include "DataChecks.h"
#include "EventLog.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using Sample::Point;
using Sample::Polygon;
using Sample::Surface;

//------------------------------------------------------------------------------
/// A prism between two regular hexagons.
Surface Prism()
{
  std::vector<Point> points;
  std::vector<Polygon> polygons = { { 5, 4, 3, 2, 1, 0 }, { 6, 7, 8, 9, 10, 11 } };
  for (vtkIdType k = 0; k < 12; ++k)
  {
    const double angle = static_cast<double>(k % 6) * std::acos(0.5);
    points.push_back({ std::cos(angle), std::sin(angle), k < 6 ? -0.5 : 0.5 });
  }
  for (vtkIdType k = 0; k < 6; ++k)
  {
    polygons.push_back({ k, (k + 1) % 6, (k + 1) % 6 + 6, k + 6 });
  }
  return Sample::Make(points, polygons);
}

//------------------------------------------------------------------------------
/// A closed surface with a bent pentagon that is concave.
Surface Concave()
{
  return Sample::Make({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0.1 }, { 1, 0.5, 0 }, { 0, 2, -0.1 },
                        { 1, 0, -1.5 }, { 1, 1, -1 } },
    { { 0, 1, 2, 3, 4 }, { 1, 0, 5 }, { 2, 1, 5 }, { 3, 2, 5, 6 }, { 4, 3, 6 }, { 0, 4, 6, 5 } });
}

//------------------------------------------------------------------------------
/// A tetrahedron whose faces have a corner in the middle of every side.
Surface WithCornersInARow()
{
  return Sample::Make({ { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 1, 0, 0 },
                        { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 }, { 0, 1, 1 }, { 1, 0, 1 } },
    { { 0, 5, 2, 7, 1, 4 }, { 0, 4, 1, 9, 3, 6 }, { 1, 7, 2, 8, 3, 9 }, { 0, 6, 3, 8, 2, 5 } });
}

//------------------------------------------------------------------------------
Surface WithATriangleCutOut()
{
  return Sample::KeepPolygons(Sample::Icosphere(2), [](vtkIdType i) { return i != 17; });
}

//------------------------------------------------------------------------------
Surface OneTriangle()
{
  return Sample::Make({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 1 } }, { { 0, 1, 2 } });
}

struct Start
{
  const char* Name;
  Surface (*Make)();
};

class PolygonStarts : public testing::TestWithParam<Start>
{
};

//------------------------------------------------------------------------------
TEST_P(PolygonStarts, Evolve)
{
  for (const int mode :
    { vtkSurfaceEvolution::FIXED, vtkSurfaceEvolution::SLIDE_ALONG, vtkSurfaceEvolution::FREE })
  {
    SCOPED_TRACE(mode);
    const Surface start = GetParam().Make();
    vtkNew<vtkSurfaceEvolution> filter;
    EventLog log(filter);
    SetUpCurvatureFlow(filter, start, 0.005, 6);
    filter->SetBoundaryMode(mode);
    filter->SetVolumeRedistribution(1.0);
    filter->SetAngleRedistribution(1.0);
    filter->SetLengthRedistribution(1.0);
    filter->UpdateTimeStep(0.0);
    const double area = FieldValue(filter->GetOutput(), "Area");
    filter->UpdateTimeStep(1.0);
    ASSERT_TRUE(log.Errors.empty()) << log.Errors.front();
    EXPECT_TRUE(IsFinite(filter->GetOutput()));
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), start->GetNumberOfPolys());
    EXPECT_EQ(FieldValue(filter->GetOutput(), "Iteration"), 6.0);
    EXPECT_LE(FieldValue(filter->GetOutput(), "Area"), area * (1.0 + 1e-12));
  }
}

//------------------------------------------------------------------------------
TEST_P(PolygonStarts, AreRedistributed)
{
  const Surface start = GetParam().Make();
  vtkNew<vtkTangentialRedistribution> filter;
  EventLog log(filter);
  filter->SetInputData(start);
  filter->SetTimeStep(1e6);
  filter->SetNumberOfSteps(3);
  filter->SetVolumeRedistribution(1.0);
  filter->SetAngleRedistribution(1e6);
  filter->SetLengthRedistribution(1e-6);
  filter->Update();
  ASSERT_TRUE(log.Errors.empty()) << log.Errors.front();
  EXPECT_TRUE(IsFinite(filter->GetOutput()));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), start->GetNumberOfPoints());
  EXPECT_LE(filter->GetOutput()->GetLength(), start->GetLength() * (1.0 + 1e-9));
}

INSTANTIATE_TEST_SUITE_P(All, PolygonStarts,
  testing::Values(Start{ "Prism", Prism }, Start{ "Concave", Concave },
    Start{ "CornersInARow", WithCornersInARow }, Start{ "TriangleCutOut", WithATriangleCutOut },
    Start{ "OneTriangle", OneTriangle }),
  [](const testing::TestParamInfo<Start>& info) { return info.param.Name; });

} // namespace
