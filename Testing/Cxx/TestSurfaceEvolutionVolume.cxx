// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// vtkSurfaceEvolution: flows that hold the volume, with the defaults of all else.

#include "DataChecks.h"
#include "EventLog.h"
#include "FlowSetups.h"
#include "SampleSurfaces.h"

#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

//------------------------------------------------------------------------------
/// 3 : 2 : 1, in floats, far from the origin.
vtkSmartPointer<vtkPolyData> Ellipsoid()
{
  auto ellipsoid = vtkSmartPointer<vtkPolyData>::New();
  ellipsoid->DeepCopy(Sample::Icosphere(3, 1.0));
  for (vtkIdType i = 0; i < ellipsoid->GetNumberOfPoints(); ++i)
  {
    const double* p = ellipsoid->GetPoint(i);
    const double moved[3] = { 50.0 + 3.0 * p[0], 2.0 * p[1], p[2] };
    ellipsoid->GetPoints()->SetPoint(i, moved);
  }
  return ellipsoid;
}

//------------------------------------------------------------------------------
struct Ratios
{
  double Volume; ///< the largest deviation of any step from the start's, of that
  double Growth; ///< of the area in a step, the largest; below 0 where it falls
};

//------------------------------------------------------------------------------
Ratios RatiosOf(vtkSurfaceEvolution* filter)
{
  vtkTable* history = HistoryOf(filter);
  const auto value = [history](vtkIdType row, const char* name)
  { return history->GetValueByName(row, name).ToDouble(); };
  Ratios ratios{ 0.0, -1.0 };
  for (vtkIdType row = 1; row < history->GetNumberOfRows(); ++row)
  {
    ratios.Volume =
      std::max(ratios.Volume, std::abs(value(row, "Volume") / value(0, "Volume") - 1.0));
    ratios.Growth = std::max(ratios.Growth, value(row, "Area") / value(row - 1, "Area") - 1.0);
  }
  return ratios;
}

//------------------------------------------------------------------------------
void ExpectBallOfSameVolume(vtkSurfaceEvolution* filter)
{
  vtkPolyData* output = filter->GetOutput();
  const double pi = std::acos(-1.0);
  const double volume = HistoryOf(filter)->GetValueByName(0, "Volume").ToDouble();
  const double radius = std::cbrt(0.75 * volume / pi);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* p = output->GetPoint(i);
    // 642 points, drawn out on the way: their own ball is so far from round.
    EXPECT_NEAR(std::hypot(p[0] - 50.0, p[1], p[2]) / radius, 1.0, 0.015);
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionVolume, EllipsoidsBecomeBallsWithTheDefaults)
{
  for (const bool isDiffusion : { false, true })
  {
    vtkNew<vtkSurfaceEvolution> filter;
    const EventLog log(filter);
    filter->SetInputData(0, Ellipsoid());
    filter->SetNumberOfSteps(60);
    filter->SetFlow(
      isDiffusion ? vtkSurfaceEvolution::SURFACE_DIFFUSION : vtkSurfaceEvolution::MEAN_CURVATURE);
    filter->SetVolumePreserving(!isDiffusion);
    filter->Update();
    EXPECT_TRUE(log.Errors.empty() && log.Warnings.empty());
    const Ratios ratios = RatiosOf(filter);
    EXPECT_LT(ratios.Volume, 1e-11);
    EXPECT_LT(ratios.Growth, 0.0);
    ExpectBallOfSameVolume(filter);
    EXPECT_EQ(filter->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
    EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("ExtinctionTime"), nullptr);
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionVolume, StatesThatWereDroppedComeBackTheSame)
{
  vtkNew<vtkSurfaceEvolution> all;
  vtkNew<vtkSurfaceEvolution> few;
  for (vtkSurfaceEvolution* filter : { all.Get(), few.Get() })
  {
    filter->SetInputData(0, Ellipsoid());
    filter->SetNumberOfSteps(30);
    filter->VolumePreservingOn();
    filter->SetRemeshingToUniform();
  }
  few->SetCacheLimit(1);
  for (const double time : { 30.0, 7.0, 18.0 })
  {
    all->UpdateTimeStep(time);
    few->UpdateTimeStep(time);
    ASSERT_EQ(all->GetOutput()->GetNumberOfPoints(), few->GetOutput()->GetNumberOfPoints());
    for (vtkIdType i = 0; i < all->GetOutput()->GetNumberOfPoints(); ++i)
    {
      double p[3];
      all->GetOutput()->GetPoint(i, p);
      const double* q = few->GetOutput()->GetPoint(i);
      EXPECT_NEAR(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 0.0, 1e-7);
    }
  }
}

//------------------------------------------------------------------------------
TEST(SurfaceEvolutionVolume, AFieldIsRefusedInASentence)
{
  for (const int flow :
    { vtkSurfaceEvolution::MEAN_CURVATURE, vtkSurfaceEvolution::SURFACE_DIFFUSION })
  {
    vtkNew<vtkSurfaceEvolution> filter;
    const EventLog log(filter);
    filter->SetInputData(0, Sample::Icosphere(2, 1.0));
    filter->SetInputData(1, Sample::SphereImage(17, 2.0, 1.0));
    filter->SetFlow(flow);
    filter->VolumePreservingOn();
    filter->Update();
    ASSERT_EQ(log.Errors.size(), 1u);
    EXPECT_TRUE(IsOneSentence(log.Errors.front())) << log.Errors.front();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

} // namespace
