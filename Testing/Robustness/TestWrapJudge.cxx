// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Judges must not sleep: every answer here is right at first, and then not.

#include "EvolutionJudge.h"
#include "JudgeChecks.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"

#include <gtest/gtest.h>

namespace
{

using namespace robustness;

class WrapJudge : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkShrinkWrap> filter;
    filter->SetInputDataObject(this->Input.data);
    filter->SetSampleDimensions(20, 20, 20);
    filter->SetTargetEdgeLength(0.3);
    filter->Update();
    this->Result->DeepCopy(filter->GetOutput());
  }

  Fault fault()
  {
    return faultOf([this]() { judgeWrap(this->Input, true, 0, this->Result); });
  }

  /// As a filter that measures what it made would say it.
  void stateTruth()
  {
    const Surface surface = surfaceOf(this->Result);
    const Topology topology = topologyOf(surface);
    setField(this->Result, "IsClosed", topology.isClosed());
    setField(this->Result, "IsManifold", topology.isManifold() && topology.isOriented());
    setField(this->Result, "Genus", double(topology.genus()));
    setField(this->Result, "MinAngle", smallestAngleOf(surface));
    setField(this->Result, "SelfIntersections", double(intersectionsOf(surface)));
    setField(this->Result, "Area", areaOf(surface));
    setField(this->Result, "Volume", volumeOf(surface, middleOf(surface)));
  }

  const Subject Input = ball();
  vtkNew<vtkPolyData> Result;
};

TEST_F(WrapJudge, PassesWhatIsRight)
{
  EXPECT_EQ(this->fault(), Fault::None);
}

TEST_F(WrapJudge, SeesAFlippedFace)
{
  setFace(this->Result, 5, [](Cell& face) { std::swap(face[0], face[1]); });
  EXPECT_EQ(this->fault(), Fault::Misstated);
  this->stateTruth();
  EXPECT_EQ(this->fault(), Fault::NotOriented);
}

TEST_F(WrapJudge, SeesAMissingFace)
{
  setFace(this->Result, 5, [](Cell& face) { face.clear(); });
  EXPECT_EQ(this->fault(), Fault::Misstated);
  this->stateTruth();
  setField(this->Result, "Genus", double(topologyOf(surfaceOf(this->Result)).genus()));
  EXPECT_EQ(this->fault(), Fault::Borders);
}

TEST_F(WrapJudge, SeesAPairThatOverlaps)
{
  this->Result->GetPoints()->SetPoint(3, -2.0, 0.1, 0.05);
  const std::int64_t pairs = intersectionsOf(surfaceOf(this->Result));
  ASSERT_GT(pairs, 0);
  this->stateTruth();
  setField(this->Result, "SelfIntersections", 0.0);
  EXPECT_EQ(this->fault(), Fault::Misstated);
}

TEST_F(WrapJudge, SeesASurfaceThatIsInsideOut)
{
  for (vtkIdType face = 0; face < this->Result->GetNumberOfCells(); ++face)
  {
    setFace(this->Result, face, [](Cell& corners) { std::swap(corners[0], corners[1]); });
  }
  this->stateTruth();
  EXPECT_EQ(this->fault(), Fault::NotOriented);
}

TEST_F(WrapJudge, SeesASurfaceWithoutVolume)
{
  vtkPoints* points = this->Result->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, p[0], p[1], 0.0);
  }
  this->stateTruth();
  EXPECT_EQ(this->fault(), Fault::NoVolume);
}

TEST_F(WrapJudge, SeesEveryLie)
{
  for (const char* name : { "IsClosed", "IsManifold", "SelfIntersections", "Genus", "MinAngle",
         "Area", "Volume", "MaxDistance" })
  {
    const double truth = this->Result->GetFieldData()->GetArray(name)->GetComponent(0, 0);
    setField(this->Result, name, truth == 0.0 ? 1.0 : 0.999 * truth);
    EXPECT_EQ(this->fault(), Fault::Misstated) << name;
    setField(this->Result, name, truth);
  }
  EXPECT_EQ(this->fault(), Fault::None);
}

TEST_F(WrapJudge, SeesWhatIsFarFromTheTargetWithoutAWord)
{
  vtkPoints* points = this->Result->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, 1.5 * p[0], 1.5 * p[1], 1.5 * p[2]);
  }
  this->stateTruth();
  EXPECT_EQ(this->fault(), Fault::TooFar);
}

} // namespace
