// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces of labels as the start of an evolution, one or all at once.

#include "EventLog.h"
#include "LabelImages.h"
#include "SurfaceMeasures.h"

#include "vtkImageData.h"
#include "vtkLabelSurfaces.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkSurfaceEvolution.h"

#include <gtest/gtest.h>

namespace
{

//------------------------------------------------------------------------------
/// Two boxes of one label that have an edge of voxels, or a corner, in common.
Image TouchingBoxes(double shift)
{
  return LabelImage(vtkNew<vtkShortArray>(),
    [=](double x, double y, double z)
    {
      const auto isIn = [](double a, double b, double c)
      { return a > 0.0 && a < 5.0 && b > 0.0 && b < 5.0 && c > 0.0 && c < 6.2; };
      return isIn(x, y, z) || isIn(x + 5.0, y + 5.0, z + shift) ? 1.0 : 0.0;
    });
}

//------------------------------------------------------------------------------
/// Expects that a flow that holds volumes can be made of all surfaces of a filter at once.
void ExpectEvolutionOf(vtkLabelSurfaces* filter)
{
  filter->Update();
  vtkNew<vtkSurfaceEvolution> evolution;
  evolution->SetInputConnection(filter->GetOutputPort());
  evolution->VolumePreservingOn();
  evolution->SetNumberOfSteps(2);
  EventLog log(evolution);
  evolution->Update();
  EXPECT_TRUE(log.Errors.empty()) << log.Errors.front();
  vtkPolyData* input = filter->GetOutput();
  EXPECT_EQ(CountBadEdges(evolution->GetOutput()), 0);
  EXPECT_NEAR(VolumeOf(evolution->GetOutput()), VolumeOf(input), 1e-3 * VolumeOf(input));
  EXPECT_LT(AreaOf(evolution->GetOutput()), AreaOf(input));
}

} // namespace

//------------------------------------------------------------------------------
TEST(LabelsInEvolution, OneOfThemGoesIntoAnEvolution)
{
  const auto surface = SurfaceOf(FilterOf(Ball()), 1.0);
  vtkNew<vtkSurfaceEvolution> evolution;
  evolution->SetInputData(surface);
  evolution->SetFlowToSurfaceDiffusion();
  evolution->SetNumberOfSteps(1);
  EventLog log(evolution);
  evolution->Update();
  EXPECT_TRUE(log.Errors.empty()) << log.Errors.front();
  EXPECT_EQ(CountBadEdges(evolution->GetOutput()), 0);
  EXPECT_NEAR(VolumeOf(evolution->GetOutput()), VolumeOf(surface), 1e-3 * VolumeOf(surface));
}

//------------------------------------------------------------------------------
TEST(LabelsInEvolution, AllGoIntoAnEvolutionThoughTheyTouch)
{
  ExpectEvolutionOf(FilterOf(Halves(), -1.0));
  ExpectEvolutionOf(FilterOf(TouchingBoxes(0.0)));
  ExpectEvolutionOf(FilterOf(TouchingBoxes(6.2)));
}
