// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "FlowSetups.h"

#include "SampleSurfaces.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceEvolution.h"
#include "vtkTable.h"
#include "vtkVariant.h"

//------------------------------------------------------------------------------
void SetUpCurvatureFlow(vtkSurfaceEvolution* filter, vtkPolyData* start, double timeStep, int steps)
{
  filter->SetInputData(start);
  filter->RelativeUnitsOff();
  filter->SetCurvatureSpeed(1.0);
  filter->SetTimeStep(timeStep);
  filter->SetNumberOfSteps(steps);
}

//------------------------------------------------------------------------------
void SetUpAttraction(vtkSurfaceEvolution* filter, vtkPolyData* start)
{
  filter->SetInputData(0, start);
  filter->SetInputData(1, Sample::SphereImage(33, 2.0, 1.0));
  filter->SetTimeStep(0.1);
  filter->SetNumberOfSteps(40);
  filter->SetCurvatureSpeed(0.01);
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
