// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TimeSteps.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace TimeSteps
{

//------------------------------------------------------------------------------
std::vector<double> Times(const std::vector<int>& iterations, double timeStep)
{
  std::vector<double> times(iterations.size());
  std::transform(iterations.begin(), iterations.end(), times.begin(),
    [timeStep](int iteration) { return iteration * timeStep; });
  return times;
}

//------------------------------------------------------------------------------
void Publish(vtkInformation* outputInformation, const std::vector<double>& times)
{
  const double range[2] = { times.front(), times.back() };
  outputInformation->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  outputInformation->Set(Pipeline::TIME_RANGE(), range, 2);
}

//------------------------------------------------------------------------------
void Remove(vtkInformation* outputInformation)
{
  outputInformation->Remove(Pipeline::TIME_STEPS());
  outputInformation->Remove(Pipeline::TIME_RANGE());
}

//------------------------------------------------------------------------------
std::size_t Requested(vtkInformation* outputRequest, const std::vector<double>& times)
{
  if (!outputRequest->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    return times.size() - 1;
  }
  const double time = outputRequest->Get(Pipeline::UPDATE_TIME_STEP());
  const auto nearest = std::min_element(times.begin(), times.end(),
    [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  return static_cast<std::size_t>(nearest - times.begin());
}

//------------------------------------------------------------------------------
void Mark(vtkDataObject* output, double time)
{
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
}

} // namespace TimeSteps
