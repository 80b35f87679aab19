// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FilterRuns.h"

#include "DataChecks.h"
#include "EventLog.h"
#include "SurfaceMeasures.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMeshSDF.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkShrinkWrap.h"
#include "vtkTangentialRedistribution.h"

#include <cmath>

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Distance(
  vtkPolyData* surface, int n, const std::function<void(vtkMeshSDF*)>& setUp)
{
  vtkNew<vtkMeshSDF> filter;
  filter->SetInputData(surface);
  filter->SetSampleDimensions(n, n, n);
  if (setUp)
  {
    setUp(filter);
  }
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
vtkInformation* InformationOf(vtkMeshSDF* filter)
{
  filter->UpdateInformation();
  return filter->GetOutputInformation(0);
}

//------------------------------------------------------------------------------
std::string NameOfMethod(const testing::TestParamInfo<int>& info)
{
  static const char* const names[] = { "ClosestPoint", "FastSweeping", "BruteForce" };
  return names[info.param];
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Redistributed(
  vtkPolyData* surface, const std::function<void(vtkTangentialRedistribution*)>& setUp)
{
  vtkNew<vtkTangentialRedistribution> filter;
  filter->SetInputData(surface);
  if (setUp)
  {
    setUp(filter);
  }
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
void SetUpCoarsely(vtkShrinkWrap* filter, vtkPolyData* input)
{
  filter->SetInputData(input);
  filter->SetSampleDimensions(40, 40, 40);
  filter->SetTargetEdgeLength(std::sqrt(AreaOf(input) / 900.0));
  filter->SetNumberOfSteps(30);
}

//------------------------------------------------------------------------------
void ExpectClosed(vtkPolyData* surface, int genus)
{
  EXPECT_EQ(FieldValue(surface, "IsClosed"), 1.0);
  EXPECT_EQ(FieldValue(surface, "IsManifold"), 1.0);
  EXPECT_EQ(FieldValue(surface, "Genus"), genus);
  EXPECT_EQ(CountBadEdges(surface), 0);
  EXPECT_EQ(EulerCharacteristic(surface), 2 - 2 * genus);
  EXPECT_GT(VolumeOf(surface), 0.0);
  EXPECT_TRUE(IsFinite(surface));
}

//------------------------------------------------------------------------------
void ExpectRefusal(vtkAlgorithm* filter, const EventLog& log, const std::string& words)
{
  ASSERT_EQ(log.Errors.size(), 1u) << words;
  EXPECT_TRUE(IsOneSentence(log.Errors.front()));
  EXPECT_NE(log.Errors.front().find(words), std::string::npos) << log.Errors.front();
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_TRUE(IsInitialized(filter->GetOutputDataObject(port)));
  }
}

//------------------------------------------------------------------------------
void ExpectRefusalOf(vtkAlgorithm* filter, const std::string& words)
{
  EventLog log(filter);
  filter->Update();
  ExpectRefusal(filter, log, words);
}
