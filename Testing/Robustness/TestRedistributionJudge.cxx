// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Judges must not sleep: every answer here is right at first, and then not.

#include "BaseShapes.h"
#include "JudgeChecks.h"
#include "RedistributionJudge.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

namespace
{

using namespace robustness;

class MovedPointsJudge : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkTangentialRedistribution> filter;
    filter->SetInputDataObject(this->Input.data);
    filter->SetNumberOfSteps(3);
    filter->SetBoundaryModeToFixed();
    filter->Update();
    this->Output->DeepCopy(filter->GetOutput());
  }

  static Subject cap()
  {
    const Model model = icosphere(2, 1.0, Vec3::Zero());
    Model upper = model;
    upper.forgetSolid();
    upper.polygons.clear();
    for (const Cell& t : model.polygons)
    {
      const auto height = [&](std::size_t k)
      { return model.points[static_cast<std::size_t>(t[k])].z(); };
      if (height(0) + height(1) + height(2) > 0.1)
      {
        upper.addPolygon(t);
      }
    }
    return Subject(upper);
  }

  Fault fault()
  {
    return faultOf([this]() { judgeRedistribution(this->Input, { true, true }, this->Output); });
  }

  const Subject Input = cap();
  vtkNew<vtkPolyData> Output;
};

TEST_F(MovedPointsJudge, PassesWhatIsRight)
{
  EXPECT_EQ(this->fault(), Fault::None);
}

TEST_F(MovedPointsJudge, SeesAPointOffTheSurface)
{
  const std::int64_t used = this->Input.surface.faces[0][0];
  double p[3];
  this->Output->GetPoint(used, p);
  this->Output->GetPoints()->SetPoint(used, 1.01 * p[0], 1.01 * p[1], 1.01 * p[2]);
  EXPECT_EQ(this->fault(), Fault::TooFar);
}

TEST_F(MovedPointsJudge, SeesOtherCells)
{
  setFace(this->Output, 0, [](Cell& face) { std::swap(face[0], face[1]); });
  EXPECT_EQ(this->fault(), Fault::ChangedInput);
}

TEST_F(MovedPointsJudge, SeesABorderThatMoved)
{
  ASSERT_GT(this->Input.topology.borderEdges, 0);
  // All to one point of the surface, which is on it.
  const Vec3 place = this->Input.surface.corner(this->Input.surface.faces[0], 0);
  for (const Cell& face : this->Input.surface.faces)
  {
    for (const std::int64_t id : face)
    {
      this->Output->GetPoints()->SetPoint(id, place.data());
    }
  }
  EXPECT_EQ(this->fault(), Fault::ChangedInput);
}

} // namespace
