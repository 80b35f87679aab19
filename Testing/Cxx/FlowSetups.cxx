// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FlowSetups.h"

#include "SampleSurfaces.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"
#include "vtkVariant.h"

//------------------------------------------------------------------------------
void SetUpCurvatureFlow(vtkSurfaceEvolution* filter, vtkPolyData* start, double timeStep, int steps)
{
  filter->SetInputData(start);
  filter->RelativeUnitsOff();
  filter->SetRemeshingToOff();
  filter->SetConvergenceTolerance(0.0);
  filter->SetCurvatureSpeed(1.0);
  filter->SetTimeStep(timeStep);
  filter->SetNumberOfSteps(steps);
}

//------------------------------------------------------------------------------
void SetUpAttraction(vtkSurfaceEvolution* filter, vtkPolyData* start)
{
  filter->SetInputData(0, start);
  filter->SetInputData(1, Sample::SphereImage(33, 2.0, 1.0));
  filter->SetRemeshingToOff();
  filter->SetConvergenceTolerance(0.0);
  filter->SetTimeStep(0.1);
  filter->SetNumberOfSteps(40);
  filter->SetCurvatureSpeed(0.01);
}

//------------------------------------------------------------------------------
std::vector<double> TimesOf(vtkAlgorithm* filter, int port)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  filter->UpdateInformation();
  vtkInformation* info = filter->GetOutputInformation(port);
  const double* times = info->Get(Pipeline::TIME_STEPS());
  return times ? std::vector<double>(times, times + info->Length(Pipeline::TIME_STEPS()))
               : std::vector<double>();
}

//------------------------------------------------------------------------------
vtkTable* HistoryOf(vtkSurfaceEvolution* filter)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
double ValueAt(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}
