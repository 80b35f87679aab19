// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "InputStep.h"

#include "KernelBridge.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

//------------------------------------------------------------------------------
std::vector<double> TimesOf(vtkInformation* input)
{
  const auto listed = [input](vtkInformationDoubleVectorKey* key)
  {
    const double* first = input->Get(key);
    return std::vector<double>(first, first + input->Length(key));
  };
  if (input->Has(Pipeline::TIME_STEPS()) && input->Length(Pipeline::TIME_STEPS()) > 0)
  {
    return listed(Pipeline::TIME_STEPS());
  }
  return input->Has(Pipeline::TIME_RANGE()) ? listed(Pipeline::TIME_RANGE())
                                            : std::vector<double>();
}

} // namespace

//------------------------------------------------------------------------------
void InputStep::Request(vtkInformation* input) const
{
  input->Remove(Pipeline::UPDATE_TIME_STEP());
  const std::vector<double> times = TimesOf(input);
  if (times.empty())
  {
    return;
  }
  const int last = static_cast<int>(times.size()) - 1;
  const int step = this->Which == First ? 0 : this->Which == Last ? last : this->Number;
  input->Set(
    Pipeline::UPDATE_TIME_STEP(), times[static_cast<std::size_t>(std::clamp(step, 0, last))]);
}

//------------------------------------------------------------------------------
void InputStep::Require(vtkInformation* input) const
{
  const std::vector<double> times = TimesOf(input);
  const int count = static_cast<int>(times.size());
  if (this->Which == Index && count > 0 && this->Number >= count)
  {
    std::ostringstream message;
    message << "InputTimeIndex is " << this->Number << ", but an input has " << count
            << " time steps, expected a number from 0 to " << count - 1 << ".";
    throw evolving::InputError(message.str());
  }
}

//------------------------------------------------------------------------------
void InputStep::Write(vtkInformation* input, vtkDataObject* output)
{
  if (!TimesOf(input).empty() && input->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    KernelBridge::AddFieldValue(output, "InputTime", input->Get(Pipeline::UPDATE_TIME_STEP()));
  }
}
