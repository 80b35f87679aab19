// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Judges must not sleep: every answer here is right at first, and then not.

#include "EvolutionJudge.h"
#include "JudgeChecks.h"
#include "OutputChecks.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using namespace robustness;

class StateJudge : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkSurfaceEvolution> filter;
    filter->SetInputDataObject(this->Input.data);
    filter->SetNumberOfSteps(3);
    filter->Update();
    this->State->DeepCopy(filter->GetOutput());
    this->History->DeepCopy(filter->GetOutputDataObject(1));
  }

  Fault fault()
  {
    return faultOf([this]() { judgeState(this->Input, false, this->State); });
  }

  const Subject Input = ball();
  vtkNew<vtkPolyData> State;
  vtkNew<vtkTable> History;
};

TEST_F(StateJudge, PassesWhatIsRight)
{
  EXPECT_EQ(this->fault(), Fault::None);
}

TEST_F(StateJudge, SeesEveryLie)
{
  for (const char* name : { "Area", "Volume", "MaxDistance", "MinAngle" })
  {
    const double truth = this->State->GetFieldData()->GetArray(name)->GetComponent(0, 0);
    setField(this->State, name, truth == 0.0 ? 1.0 : 0.9999 * truth);
    EXPECT_EQ(this->fault(), Fault::Misstated) << name;
    setField(this->State, name, truth);
  }
}

TEST_F(StateJudge, SeesOtherFaces)
{
  setFace(this->State, 3, [](Cell& face) { std::swap(face[0], face[1]); });
  EXPECT_EQ(this->fault(), Fault::NotOriented);
  setFace(this->State, 3, [](Cell& face) { face.clear(); });
  EXPECT_EQ(this->fault(), Fault::Borders);
}

TEST_F(StateJudge, SeesAMissingArray)
{
  this->State->GetPointData()->RemoveArray("CoVolume");
  EXPECT_EQ(this->fault(), Fault::Misstated);
}

TEST_F(StateJudge, HoldsTheHistoryAgainstTheState)
{
  const auto judge = [this]() { judgeHistory(this->History, this->State, { "Area", "MinAngle" }); };
  EXPECT_EQ(faultOf(judge), Fault::None);
  setField(this->State, "Area", 1.0);
  EXPECT_EQ(faultOf(judge), Fault::Misstated);
}

TEST_F(StateJudge, SeesNumbersThatAreNone)
{
  EXPECT_EQ(faultOf([this]() { requireFinite(this->State); }), Fault::None);
  this->State->GetPointData()
    ->GetArray("CoVolume")
    ->SetComponent(7, 0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(faultOf([this]() { requireFinite(this->State); }), Fault::NotFinite);
}

} // namespace
