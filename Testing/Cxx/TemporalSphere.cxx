// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TemporalSphere.h"

#include "SampleSurfaces.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkStandardNewMacro(TemporalSphere);

//------------------------------------------------------------------------------
TemporalSphere::TemporalSphere()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
int TemporalSphere::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const double times[3] = { 0.0, 1.0, 2.0 };
  const double range[2] = { 0.0, 2.0 };
  vtkInformation* info = outputVector->GetInformationObject(0);
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times, 3);
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  return 1;
}

//------------------------------------------------------------------------------
int TemporalSphere::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const auto timeKey = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  vtkInformation* info = outputVector->GetInformationObject(0);
  const double time = info->Has(timeKey) ? info->Get(timeKey) : 0.0;
  this->Asked.push_back(time);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(Sample::Icosphere(1, 1.0 + time));
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  return 1;
}
