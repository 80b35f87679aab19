// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "AbortFlag.h"
#include "KernelThreads.h"

#include "vtkAlgorithm.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <array>
#include <exception>
#include <iomanip>
#include <new>
#include <sstream>
#include <stdexcept>
#include <system_error>

namespace KernelBridge
{

namespace
{

//------------------------------------------------------------------------------
evolving::Execution ExecutionOf(vtkAlgorithm* filter)
{
  return evolving::Execution(
    KernelThreads::For, [filter](double fraction) { filter->UpdateProgress(fraction); },
    [filter]() { return AbortFlag::IsSet(filter); });
}

//------------------------------------------------------------------------------
void SayOutOfMemory(vtkAlgorithm* filter)
{
  vtkErrorWithObjectMacro(
    filter, "The computation ran out of memory; use fewer samples or a smaller mesh.");
}

} // namespace

//------------------------------------------------------------------------------
Outcome Run(vtkAlgorithm* filter, const std::function<void(const evolving::Execution&)>& work)
{
  AbortFlag::Restore(filter);
  try
  {
    KernelThreads::With([&]() { work(ExecutionOf(filter)); });
    return Outcome::Finished;
  }
  catch (const evolving::Cancelled&)
  {
    return Outcome::Cancelled;
  }
  catch (const std::bad_alloc&)
  {
    SayOutOfMemory(filter);
  }
  catch (const std::length_error&)
  {
    // Of a standard container that was to have more elements than there are addresses.
    SayOutOfMemory(filter);
  }
  catch (const std::system_error&)
  {
    // VTK 9.3 starts threads of its own when it is asked how many there are.
    vtkErrorWithObjectMacro(filter,
      "The system gave VTK no thread, as it does when memory runs out; close other programs, or "
      "set "
      "VTK_SMP_MAX_THREADS to a smaller number.");
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(filter, << error.what());
  }
  return Outcome::Failed;
}

//------------------------------------------------------------------------------
int RunToOutputs(vtkAlgorithm* filter, const std::vector<vtkDataObject*>& outputs,
  const std::function<void(const evolving::Execution&)>& work)
{
  const Outcome outcome = Run(filter, work);
  if (outcome != Outcome::Finished)
  {
    for (vtkDataObject* output : outputs)
    {
      output->Initialize();
    }
  }
  return outcome == Outcome::Failed ? 0 : 1;
}

//------------------------------------------------------------------------------
bool IsAutomatic(const double bounds[6])
{
  return bounds[0] > bounds[1] && bounds[2] > bounds[3] && bounds[4] > bounds[5];
}

//------------------------------------------------------------------------------
evolving::DistanceGrid MakeGrid(
  const evolving::Box& box, const int dimensions[3], const double bounds[6], double padding)
{
  const std::array<int, 3> samples = { dimensions[0], dimensions[1], dimensions[2] };
  if (IsAutomatic(bounds))
  {
    return evolving::gridAround(box, samples, padding);
  }
  const evolving::Vec3 lower(bounds[0], bounds[2], bounds[4]);
  const evolving::Vec3 upper(bounds[1], bounds[3], bounds[5]);
  return evolving::gridOver(evolving::Box(lower, upper), samples);
}

//------------------------------------------------------------------------------
bool AssignClamped(const int wanted[3], int lower, int upper, int stored[3])
{
  bool changed = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int value = std::clamp(wanted[axis], lower, upper);
    changed = changed || value != stored[axis];
    stored[axis] = value;
  }
  return changed;
}

//------------------------------------------------------------------------------
void RequestWholeInput(vtkInformation* inputRequest)
{
  // VTK hands the extent of an image behind this filter on, through polydata, to images before it.
  inputRequest->Remove(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT());
  inputRequest->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
  inputRequest->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  inputRequest->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

//------------------------------------------------------------------------------
void RequestWholeImage(vtkInformation* inputRequest)
{
  RequestWholeInput(inputRequest);
  if (inputRequest->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    int extent[6];
    inputRequest->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
    inputRequest->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
  }
}

//------------------------------------------------------------------------------
bool WritesGeometry(vtkInformation* request, vtkInformationVector* outputVector)
{
  // An update names the piece on the port it came from; the other ports keep an older one.
  const auto fromPort = vtkExecutive::FROM_OUTPUT_PORT();
  const int port = request->Has(fromPort) ? std::max(0, request->Get(fromPort)) : 0;
  vtkInformation* output = outputVector->GetInformationObject(port);
  const auto piece = vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER();
  return !output->Has(piece) || output->Get(piece) == 0;
}

//------------------------------------------------------------------------------
int RefuseUnlessEmpty(vtkAlgorithm* filter, vtkPolyData* input)
{
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  vtkErrorWithObjectMacro(filter,
    << "The input has " << input->GetNumberOfPoints()
    << " points but no polygons, expected a surface; use Shrink Wrap, which takes points too.");
  return 0;
}

//------------------------------------------------------------------------------
void RequireMemory(evolving::GridIndex samples, const evolving::SignedDistanceOptions& options)
{
  RequireMemory(samples, evolving::peakBytesPerSample(options),
    "lower SampleDimensions, or ask for a part of the grid at a time");
}

//------------------------------------------------------------------------------
void RequireMemory(evolving::GridIndex samples, int bytesPerSample, const char* advice)
{
  vtksys::SystemInformation system;
  const double available = 1024.0 * static_cast<double>(system.GetHostMemoryTotal());
  const double needed = static_cast<double>(bytesPerSample) * static_cast<double>(samples);
  if (needed > available)
  {
    std::ostringstream message;
    message << std::fixed << std::setprecision(0) << "A grid of " << samples << " samples needs "
            << needed << " bytes, but this machine has " << available << "; " << advice << ".";
    throw evolving::InputError(message.str());
  }
}

} // namespace KernelBridge
