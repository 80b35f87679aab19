// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Judges must not sleep: every answer here is right at first, and then not.

#include "DistanceJudge.h"
#include "JudgeChecks.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

namespace
{

using namespace robustness;

class DistanceJudge : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputDataObject(this->Input.data);
    this->Filter->SetSampleDimensions(12, 12, 12);
    this->Filter->ComputeClosestPointOn();
    this->Filter->ComputeClosestCellIdOn();
    this->Filter->ComputeGradientOn();
    this->Filter->Update();
    this->Image->DeepCopy(this->Filter->GetOutput());
  }

  Fault fault()
  {
    return faultOf([this]() { judgeDistances(this->Input, this->Filter, this->Image); });
  }

  void change(const char* array, vtkIdType sample, const std::function<double(double)>& map)
  {
    vtkDataArray* values = this->Image->GetPointData()->GetArray(array);
    values->SetComponent(sample, 0, map(values->GetComponent(sample, 0)));
  }

  const Subject Input = ball();
  vtkNew<vtkMeshSDF> Filter;
  vtkNew<vtkImageData> Image;
};

constexpr vtkIdType Middle = 6 + 12 * (6 + 12 * 6);

TEST_F(DistanceJudge, PassesWhatIsRight)
{
  EXPECT_EQ(this->fault(), Fault::None);
}

TEST_F(DistanceJudge, SeesADistanceThatIsATenthOfACellOff)
{
  const double tenth = 0.1 * this->Image->GetSpacing()[0];
  this->change("SignedDistance", 5, [tenth](double d) { return d + tenth; });
  EXPECT_EQ(this->fault(), Fault::WrongDistance);
}

TEST_F(DistanceJudge, SeesADistanceThatIsALittleTooShort)
{
  this->change("SignedDistance", 5, [](double d) { return 0.9999 * d; });
  EXPECT_EQ(this->fault(), Fault::WrongDistance);
}

TEST_F(DistanceJudge, SeesAWrongSide)
{
  this->change("SignedDistance", Middle, [](double d) { return -d; });
  EXPECT_EQ(this->fault(), Fault::WrongSign);
  this->change("SignedDistance", Middle, [](double d) { return -d; });
  this->change("SignedDistance", 0, [](double d) { return -d; });
  EXPECT_EQ(this->fault(), Fault::WrongSign);
}

TEST_F(DistanceJudge, SeesAnotherClosestPointOrCell)
{
  this->change("ClosestPoint", 5, [](double x) { return x + 0.01; });
  EXPECT_EQ(this->fault(), Fault::WrongDistance);
  this->change("ClosestPoint", 5, [](double x) { return x - 0.01; });
  this->change("ClosestCellId", 5, [](double id) { return id < 160.0 ? id + 160.0 : id - 160.0; });
  EXPECT_EQ(this->fault(), Fault::WrongDistance);
}

TEST_F(DistanceJudge, SeesAGradientThatIsTooLong)
{
  this->change("Gradient", 5, [](double x) { return x + 1.0; });
  EXPECT_EQ(this->fault(), Fault::Misstated);
}

TEST_F(DistanceJudge, SeesAMethodThatWasNotAskedFor)
{
  this->Filter->SetSignToFloodFill();
  EXPECT_EQ(this->fault(), Fault::Misstated);
}

TEST_F(DistanceJudge, SeesAPartThatDiffersFromTheWhole)
{
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(this->Image);
  EXPECT_EQ(faultOf([&]() { judgePart(this->Image, whole); }), Fault::None);
  this->change("SignedDistance", 100, [](double d) { return d * (1.0 + 1e-6); });
  EXPECT_EQ(faultOf([&]() { judgePart(this->Image, whole); }), Fault::Misstated);
}

TEST(FloodFillJudge, KnowsTheSideAwayFromTheSurfaceToo)
{
  const Subject input = ball();
  vtkNew<vtkMeshSDF> filter;
  filter->SetInputDataObject(input.data);
  filter->SetSampleDimensions(16, 16, 16);
  filter->SetPadding(0.5);
  filter->SetSignToFloodFill();
  filter->Update();
  vtkImageData* image = filter->GetOutput();
  const auto judge = [&]() { judgeDistances(input, filter, image); };
  EXPECT_EQ(faultOf(judge), Fault::None);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const vtkIdType middle = 8 + 16 * (8 + 16 * 8);
  values->SetComponent(middle, 0, -values->GetComponent(middle, 0));
  EXPECT_EQ(faultOf(judge), Fault::WrongSign);
}

} // namespace
