// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkTangentialRedistribution: sharp edges, corners and boundaries.

#include "ChangedSurfaces.h"
#include "FilterRuns.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{

using Sample::Point;

//------------------------------------------------------------------------------
TEST(TangentialRedistributionCurves, SharpEdgesAndCornersAreKept)
{
  const auto cube = Sample::Mapped(Sample::Box(8), Sample::TowardsACorner);
  const auto output = Redistributed(cube);
  const auto sidesOf = [](const double p[3])
  { return std::count_if(p, p + 3, [](double x) { return std::abs(std::abs(x) - 1.0) < 1e-9; }); };
  double farthest = 0.0;
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    double before[3];
    double after[3];
    cube->GetPoint(i, before);
    output->GetPoint(i, after);
    ASSERT_GE(sidesOf(after), sidesOf(before)) << "point " << i;
    if (sidesOf(before) == 3)
    {
      ASSERT_NEAR(vtkMath::Distance2BetweenPoints(before, after), 0.0, 1e-24);
    }
    farthest = std::max(farthest, vtkMath::Distance2BetweenPoints(before, after));
  }
  EXPECT_GT(farthest, 1e-3);
  EXPECT_NEAR(AreaOf(output), 24.0, 1e-9);
  EXPECT_LT(SpreadOfAreas(output), SpreadOfAreas(cube));
}

//------------------------------------------------------------------------------
class TangentialRedistributionBoundary : public testing::TestWithParam<int>
{
};

TEST_P(TangentialRedistributionBoundary, DoesWhatItsModeSays)
{
  const auto sheet = Sample::Mapped(Sample::Sheet(10),
    [](const Point& p) -> Point
    {
      const Point drawn = Sample::TowardsACorner(p);
      return { drawn[0], drawn[1], 0.0 };
    });
  const auto output = Redistributed(sheet,
    [](vtkTangentialRedistribution* filter)
    {
      filter->SetBoundaryMode(GetParam());
      filter->SetLengthRedistribution(1.0);
    });
  double farthest = 0.0;
  for (vtkIdType i = 0; i < sheet->GetNumberOfPoints(); ++i)
  {
    double before[3];
    double after[3];
    sheet->GetPoint(i, before);
    output->GetPoint(i, after);
    ASSERT_NEAR(after[2], 0.0, 1e-12);
    for (int axis = 0; axis < 2; ++axis)
    {
      if (std::abs(before[axis]) > 1.0 - 1e-12 && GetParam() != vtkTangentialRedistribution::FREE)
      {
        ASSERT_NEAR(after[axis], before[axis], 1e-9);
        farthest = std::max(farthest, std::abs(after[1 - axis] - before[1 - axis]));
      }
    }
  }
  if (GetParam() == vtkTangentialRedistribution::FIXED)
  {
    EXPECT_EQ(farthest, 0.0);
  }
  else if (GetParam() == vtkTangentialRedistribution::SLIDE_ALONG)
  {
    EXPECT_GT(farthest, 0.05);
  }
  EXPECT_LT(SpreadOfAreas(output), SpreadOfAreas(sheet));
}

INSTANTIATE_TEST_SUITE_P(Modes, TangentialRedistributionBoundary,
  testing::Values(vtkTangentialRedistribution::FIXED, vtkTangentialRedistribution::SLIDE_ALONG,
    vtkTangentialRedistribution::FREE));

} // namespace
