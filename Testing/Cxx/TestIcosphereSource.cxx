// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkIcosphereSource: counts, places, types and orientation of the start surfaces.

#include "DataChecks.h"
#include "EventLog.h"
#include "SurfaceMeasures.h"

#include "vtkIcosphereSource.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

//------------------------------------------------------------------------------
TEST(IcosphereSource, EachLevelHasFourTimesTheTriangles)
{
  vtkNew<vtkIcosphereSource> source;
  vtkIdType triangles = 20;
  for (int level = 0; level <= 5; ++level, triangles *= 4)
  {
    source->SetLevel(level);
    source->Update();
    EXPECT_EQ(source->GetOutput()->GetNumberOfPolys(), triangles);
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), triangles / 2 + 2);
    EXPECT_EQ(source->GetOutput()->GetMaxCellSize(), 3);
  }
}

//------------------------------------------------------------------------------
class IcosphereSourceShape : public testing::TestWithParam<int>
{
};

TEST_P(IcosphereSourceShape, IsClosedAndOutwards)
{
  vtkNew<vtkIcosphereSource> source;
  source->SetShape(GetParam());
  source->SetResolution(7);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  EXPECT_EQ(CountBadEdges(source->GetOutput()), 0);
  EXPECT_EQ(EulerCharacteristic(source->GetOutput()), 2);
  const double whole = GetParam() == vtkIcosphereSource::BOX ? 8.0 : 4.0 / 3.0 * vtkMath::Pi();
  EXPECT_NEAR(VolumeOf(source->GetOutput()), whole, 0.05 * whole);
}

TEST_P(IcosphereSourceShape, TakesRadiusAndCentre)
{
  vtkNew<vtkIcosphereSource> source;
  source->SetShape(GetParam());
  source->SetRadius(2.5);
  source->SetCenter(1.0, -2.0, 3.0);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  const bool isBox = GetParam() == vtkIcosphereSource::BOX;
  const Range radius = RangeOverPoints(source->GetOutput(),
    [isBox](const double p[3])
    {
      const double x = p[0] - 1.0;
      const double y = p[1] + 2.0;
      const double z = p[2] - 3.0;
      return isBox ? std::max({ std::abs(x), std::abs(y), std::abs(z) }) : std::hypot(x, y, z);
    });
  EXPECT_NEAR(radius.Smallest, 2.5, 1e-12);
  EXPECT_NEAR(radius.Largest, 2.5, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Shapes, IcosphereSourceShape,
  testing::Values(
    vtkIcosphereSource::ICOSPHERE, vtkIcosphereSource::CUBE_SPHERE, vtkIcosphereSource::BOX));

//------------------------------------------------------------------------------
TEST(IcosphereSource, QuadShapesFollowTheResolution)
{
  vtkNew<vtkIcosphereSource> source;
  for (const int shape : { vtkIcosphereSource::CUBE_SPHERE, vtkIcosphereSource::BOX })
  {
    for (const int n : { 1, 2, 9 })
    {
      source->SetShape(shape);
      source->SetResolution(n);
      source->Update();
      EXPECT_EQ(source->GetOutput()->GetNumberOfPolys(), 6 * n * n);
      EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 6 * n * n + 2);
      EXPECT_EQ(source->GetOutput()->GetMaxCellSize(), 4);
    }
  }
}

//------------------------------------------------------------------------------
TEST(IcosphereSource, PointsThatFallTogetherAreRefused)
{
  // At a million single precision has steps of 1/16: edges of 1/30 are lost, in double they are
  // not.
  vtkNew<vtkIcosphereSource> source;
  EventLog log(source);
  source->SetLevel(5);
  source->SetCenter(1e6, 0.0, 0.0);
  source->Update();
  ASSERT_EQ(log.Errors.size(), 1u);
  EXPECT_TRUE(IsOneSentence(log.Errors.front()));
  EXPECT_NE(log.Errors.front().find("OutputPointsPrecision"), std::string::npos);
  EXPECT_TRUE(IsInitialized(source->GetOutput()));
  log.Clear();
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 10242);
}

//------------------------------------------------------------------------------
TEST(IcosphereSource, PrecisionIsChosen)
{
  vtkNew<vtkIcosphereSource> source;
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
}

} // namespace
