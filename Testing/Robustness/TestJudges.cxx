// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Judges must not sleep: every answer here is right at first, and then not.

#include "BaseShapes.h"
#include "DistanceJudge.h"
#include "EvolutionJudge.h"
#include "OutputChecks.h"
#include "RedistributionJudge.h"
#include "Verdict.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace
{

using namespace robustness;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// What a judge finds; None when it finds nothing.
Fault faultOf(const std::function<void()>& judge)
{
  try
  {
    judge();
    return Fault::None;
  }
  catch (const WrongAnswer& answer)
  {
    return answer.fault();
  }
}

Subject ball()
{
  return Subject(icosphere(2, 1.0, Vec3::Zero()));
}

void setField(vtkDataObject* data, const char* name, double value)
{
  data->GetFieldData()->GetArray(name)->SetComponent(0, 0, value);
}

/// Gives a face other corners.
void setFace(vtkPolyData* data, vtkIdType face, const std::function<void(Cell&)>& change)
{
  Surface surface = surfaceOf(data);
  change(surface.faces[static_cast<std::size_t>(face)]);
  vtkNew<vtkCellArray> cells;
  for (const Cell& corners : surface.faces)
  {
    const std::vector<vtkIdType> ids(corners.begin(), corners.end());
    if (!ids.empty())
    {
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
  data->SetPolys(cells);
}

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
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
  this->State->GetPointData()->GetArray("CoVolume")->SetComponent(7, 0, NaN);
  EXPECT_EQ(faultOf([this]() { requireFinite(this->State); }), Fault::NotFinite);
}

//------------------------------------------------------------------------------
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
