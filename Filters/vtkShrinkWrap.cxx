// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkShrinkWrap.h"

#include "DistributedInput.h"
#include "EvolutionCache.h"
#include "EvolutionOutput.h"
#include "KernelBridge.h"
#include "TimeSteps.h"
#include "WrapReport.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <string>

vtkStandardNewMacro(vtkShrinkWrap);

namespace
{

constexpr int SmallestDimension = 8;
constexpr int LargestDimension = 4096;
constexpr std::size_t SeriesBytes = std::size_t(2048) << 20;

//------------------------------------------------------------------------------
std::vector<int> PublishedIterations(const evolving::ShrinkWrapOptions& options)
{
  return evolving::publishedIterations(evolving::stepsOf(options), 0, 1);
}

} // namespace

//------------------------------------------------------------------------------
/// The last solve, and what is said of it.
struct vtkShrinkWrap::Cache : EvolutionCache<evolving::ShrinkWrapOptions>
{
  evolving::SurfaceReport Report;
  std::vector<std::string> Shortcomings;
};

//------------------------------------------------------------------------------
vtkShrinkWrap::vtkShrinkWrap()
  : Solved(std::make_unique<Cache>())
  , WholeInput(std::make_unique<DistributedInput>())
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkShrinkWrap::~vtkShrinkWrap() = default;

//------------------------------------------------------------------------------
void vtkShrinkWrap::SetSampleDimensions(int x, int y, int z)
{
  const int dimensions[3] = { x, y, z };
  this->SetSampleDimensions(dimensions);
}

//------------------------------------------------------------------------------
void vtkShrinkWrap::SetSampleDimensions(const int dimensions[3])
{
  int usable[3];
  std::transform(dimensions, dimensions + 3, usable,
    [](int n) { return n > 0 ? std::max(n, SmallestDimension) : 0; });
  if (KernelBridge::AssignClamped(usable, 0, LargestDimension, this->SampleDimensions))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkShrinkWrap::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
evolving::ShrinkWrapOptions vtkShrinkWrap::Options() const
{
  evolving::ShrinkWrapOptions options;
  options.start = static_cast<evolving::WrapStart>(this->Start);
  std::copy(this->SampleDimensions, this->SampleDimensions + 3, options.sampleDimensions.begin());
  options.targetEdgeLength = this->TargetEdgeLength;
  options.targetNumberOfPoints = this->TargetNumberOfPoints;
  options.gapSize = this->GapSize;
  options.adaptToCurvature = this->AdaptToCurvature;
  options.preserveFeatures = static_cast<evolving::FeaturePreservation>(this->PreserveFeatures);
  options.featureAngle = this->FeatureAngle;
  options.numberOfSteps = this->NumberOfSteps;
  options.offsetDistance = this->OffsetDistance;
  return options;
}

//------------------------------------------------------------------------------
int vtkShrinkWrap::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  TimeSteps::Remove(outputVector->GetInformationObject(0));
  TimeSteps::Remove(outputVector->GetInformationObject(1));
  if (this->OutputSteps)
  {
    TimeSteps::Publish(outputVector->GetInformationObject(0), this->Times());
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkShrinkWrap::ModifyRequest(vtkInformation* request, int when)
{
  this->WholeInput->Exchange(this, request, when);
  return this->Superclass::ModifyRequest(request, when);
}

//------------------------------------------------------------------------------
int vtkShrinkWrap::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  TimeSteps::RequestLastStep(input);
  this->WholeInput->RequestSurface(input);
  return 1;
}

//------------------------------------------------------------------------------
int vtkShrinkWrap::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->WholeInput->IsRefused())
  {
    return 0;
  }
  vtkPolyData* input = this->WholeInput->Surface(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* history = vtkTable::GetData(outputVector, 1);
  if (!KernelBridge::WritesGeometry(request, outputVector))
  {
    EvolutionArrays::WriteEmpty(output, true);
    EvolutionArrays::WriteEmptyHistory(history);
    return 1;
  }
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const std::vector<double> times = this->Times();
  const std::size_t step = this->OutputSteps
    ? TimeSteps::Requested(outputVector->GetInformationObject(0), times)
    : times.size() - 1;
  return KernelBridge::RunToOutputs(this, { output, history },
    [&](const evolving::Execution& execution)
    {
      this->Solved->Check({ input }, this->Options());
      if (!this->Solved->Series)
      {
        this->Solve(input, execution);
      }
      EvolutionOutput& series = *this->Solved->Series;
      series.WriteState(step, output, execution);
      series.WriteHistory(history);
      if (step + 1 == times.size())
      {
        WrapReport::Write(this->Solved->Report, this->Solved->Shortcomings, output);
      }
      if (this->OutputSteps)
      {
        TimeSteps::Mark(output, times[step]);
      }
    });
}

//------------------------------------------------------------------------------
std::vector<double> vtkShrinkWrap::Times() const
{
  const evolving::ShrinkWrapOptions options = this->Options();
  return TimeSteps::Times(PublishedIterations(options), evolving::timeStepOf(options));
}

//------------------------------------------------------------------------------
void vtkShrinkWrap::Solve(vtkPolyData* input, const evolving::Execution& execution)
{
  ++this->NumberOfSolves;
  const evolving::ShrinkWrapOptions options = this->Options();
  KernelBridge::RequireMemory(
    evolving::mostSamples(options), evolving::wrapBytesPerSample(), "lower SampleDimensions");
  const KernelBridge::UsableMesh target =
    KernelBridge::ReadUsable(input, execution.phase(0.0, 0.0));
  const evolving::ShrinkWrapProblem problem =
    evolving::prepareShrinkWrap(target.mesh, options, execution.phase(0.0, 0.3));
  const auto makeFlow = [problem](const evolving::Execution& host)
  {
    return evolving::SurfaceFlow(
      problem.start, problem.field, problem.remesher, problem.flow, host);
  };
  auto series = std::make_unique<EvolutionOutput>(KernelBridge::PointType(input), true, makeFlow,
    PublishedIterations(options), SeriesBytes, execution.phase(0.3, 0.9),
    evolving::bytesOf(problem));
  const evolving::SurfaceMesh result =
    series->Mesh(PublishedIterations(options).size() - 1, execution.phase(0.9, 0.9));
  this->Solved->Report = WrapReport::Examine(result, problem, *series, execution.phase(0.9, 1.0));
  this->Solved->Shortcomings = evolving::shortcomings(this->Solved->Report, problem.edgeLength);
  if (!target.leftOut.empty())
  {
    this->Solved->Shortcomings.insert(this->Solved->Shortcomings.begin(), target.leftOut);
  }
  this->Solved->Series = std::move(series);
  this->Warn(input);
}

//------------------------------------------------------------------------------
void vtkShrinkWrap::Warn(vtkPolyData* input)
{
  const Cache& solved = *this->Solved;
  if (solved.Series->PointType() != KernelBridge::PointType(input))
  {
    KernelBridge::WarnOfDoubles(this);
  }
  if (!solved.Series->Flow().stopReason().empty())
  {
    // The state before it has been finished all the same.
    vtkWarningMacro(<< solved.Series->Flow().stopReason());
  }
  for (const std::string& shortcoming : solved.Shortcomings)
  {
    vtkWarningMacro(<< shortcoming);
  }
}

//------------------------------------------------------------------------------
void vtkShrinkWrap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const int* n = this->SampleDimensions;
  os << indent << "OutputSteps: " << this->OutputSteps << "\n";
  os << indent << "Start: " << this->Start << "\n";
  os << indent << "SampleDimensions: " << n[0] << " " << n[1] << " " << n[2] << "\n";
  os << indent << "TargetEdgeLength: " << this->TargetEdgeLength << "\n";
  os << indent << "TargetNumberOfPoints: " << this->TargetNumberOfPoints << "\n";
  os << indent << "GapSize: " << this->GapSize << "\n";
  os << indent << "AdaptToCurvature: " << this->AdaptToCurvature << "\n";
  os << indent << "PreserveFeatures: " << this->PreserveFeatures << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "OffsetDistance: " << this->OffsetDistance << "\n";
  os << indent << "NumberOfSolves: " << this->NumberOfSolves << "\n";
}
