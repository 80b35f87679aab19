// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

// The pipeline that users write themselves, from a reader to an even surface.

#include "DataChecks.h"
#include "EventLog.h"
#include "SampleSurfaces.h"
#include "SurfaceMeasures.h"

#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTangentialRedistribution.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

//------------------------------------------------------------------------------
/// Reader, distance, a start surface one and a half cells outside, evolution, redistribution.
class Pipeline : public testing::Test
{
protected:
  Pipeline()
  {
    this->Reader->SetFileName((std::string(EVOLVINGSURFACES_DATA_DIR) + "/bunny.ply").c_str());
    this->Distance->SetInputConnection(this->Reader->GetOutputPort());
    this->Distance->SetSampleDimensions(36, 36, 36);
    this->Distance->Update();
    this->Start->SetInputConnection(this->Distance->GetOutputPort());
    this->Start->SetValue(0, 1.5 * this->Distance->GetOutput()->GetSpacing()[0]);
    this->Evolution->SetInputConnection(0, this->Start->GetOutputPort());
    this->Evolution->SetInputConnection(1, this->Distance->GetOutputPort());
    this->Evolution->SetTimeStep(0.1);
    this->Evolution->SetNumberOfSteps(30);
    this->Evolution->SetCurvatureSpeed(0.001);
    this->Evolution->SetAngleRedistribution(3.0);
    this->Even->SetInputConnection(this->Evolution->GetOutputPort());
    this->Even->SetNumberOfSteps(10);
  }

  vtkNew<vtkPLYReader> Reader;
  vtkNew<vtkMeshSDF> Distance;
  vtkNew<vtkFlyingEdges3D> Start;
  vtkNew<vtkSurfaceEvolution> Evolution;
  vtkNew<vtkTangentialRedistribution> Even;
};

//------------------------------------------------------------------------------
TEST_F(Pipeline, EndsOnTheModelWithEvenElements)
{
  EventLog log(this->Evolution);
  this->Even->Update();
  EXPECT_TRUE(log.Errors.empty());
  vtkPolyData* evolved = this->Evolution->GetOutput();
  vtkPolyData* output = this->Even->GetOutput();
  const double cell = this->Distance->GetOutput()->GetSpacing()[0];
  EXPECT_EQ(CountBadEdges(output), 0);
  EXPECT_TRUE(IsFinite(output));
  EXPECT_LT(FieldValue(evolved, "MeanDistance"), 0.3 * cell);
  EXPECT_LT(LargestDistance(output, this->Reader->GetOutput()), 1.5 * cell);
  // vtkFlyingEdges3D turns its triangles to the smaller values, which is inwards.
  const double volume = VolumeOf(this->Reader->GetOutput());
  EXPECT_LT(VolumeOf(this->Start->GetOutput()), 0.0);
  EXPECT_NEAR(VolumeOf(output), volume, 0.1 * volume);
  EXPECT_GT(MeanAngleOf(output), MeanAngleOf(this->Start->GetOutput()));
}

//------------------------------------------------------------------------------
TEST_F(Pipeline, TimePassesThroughToTheEnd)
{
  this->Even->UpdateTimeStep(1.0);
  EXPECT_EQ(FieldValue(this->Even->GetOutput(), "Iteration"), 10.0);
  this->Even->UpdateTimeStep(2.0);
  EXPECT_EQ(FieldValue(this->Even->GetOutput(), "Iteration"), 20.0);
  EXPECT_EQ(this->Evolution->GetNumberOfSolves(), 1);
}

//------------------------------------------------------------------------------
TEST_F(Pipeline, WhatIsDownstreamDoesNotSolveAgain)
{
  this->Even->Update();
  this->Even->SetNumberOfSteps(3);
  this->Even->Update();
  EXPECT_EQ(this->Evolution->GetNumberOfSolves(), 1);
  this->Start->SetValue(0, 2.0 * this->Distance->GetOutput()->GetSpacing()[0]);
  this->Even->Update();
  EXPECT_EQ(this->Evolution->GetNumberOfSolves(), 2);
}

//------------------------------------------------------------------------------
TEST_F(Pipeline, TheDistanceOfAnEvolutionFollowsItsTime)
{
  // A distance of the evolving surface itself: vtkMeshSDF passes the time upstream.
  vtkNew<vtkMeshSDF> distance;
  distance->SetInputConnection(this->Evolution->GetOutputPort());
  distance->SetSampleDimensions(8, 8, 8);
  distance->UpdateTimeStep(0.0);
  double before[6];
  distance->GetOutput()->GetBounds(before);
  distance->UpdateTimeStep(3.0);
  EXPECT_LT(distance->GetOutput()->GetBounds()[1], before[1]);
  EXPECT_EQ(this->Evolution->GetNumberOfSolves(), 1);
}

//------------------------------------------------------------------------------
TEST_F(Pipeline, AWrapOfTheResultIsPossible)
{
  vtkNew<vtkShrinkWrap> wrap;
  EventLog log(wrap);
  wrap->SetInputConnection(this->Even->GetOutputPort());
  wrap->SetSampleDimensions(36, 36, 36);
  wrap->SetTargetEdgeLength(2.0 * this->Distance->GetOutput()->GetSpacing()[0]);
  wrap->SetNumberOfSteps(20);
  wrap->Update();
  EXPECT_TRUE(log.Errors.empty());
  EXPECT_EQ(CountBadEdges(wrap->GetOutput()), 0);
}

//------------------------------------------------------------------------------
TEST(PipelineExtent, AnImageAfterAContourOfAnImageHasItsOwnExtent)
{
  // VTK hands an image's extent on through polydata: the contour must see its whole input.
  vtkNew<vtkMeshSDF> large;
  large->SetInputData(Sample::Icosphere(2));
  large->SetSampleDimensions(24, 24, 24);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(large->GetOutputPort());
  contour->SetValue(0, 0.0);
  vtkNew<vtkMeshSDF> small;
  small->SetInputConnection(contour->GetOutputPort());
  small->SetSampleDimensions(8, 8, 8);
  small->Update();
  EXPECT_EQ(CountBadEdges(contour->GetOutput()), 0);
  EXPECT_NEAR(small->GetOutput()->GetBounds()[0], -1.2, 0.03);
}

} // namespace
