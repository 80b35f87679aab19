// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkShrinkWrap.h"

#include "AbortFlag.h"
#include "CarriedArrays.h"
#include "ClosestElements.h"
#include "DataTransfer.h"
#include "DistributedInput.h"
#include "EvolutionCache.h"
#include "EvolutionOutput.h"
#include "InputStep.h"
#include "KernelBridge.h"
#include "TimeSteps.h"
#include "WrapReport.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
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
  std::unique_ptr<const ClosestElements> Closest; ///< made when there are data
  MisfitWarning Misfits;
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
  // Otherwise both outputs have the input's times, as VTK copies them.
  if (this->OutputSteps)
  {
    TimeSteps::Publish(outputVector->GetInformationObject(0), this->Times());
    TimeSteps::Remove(outputVector->GetInformationObject(1));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkShrinkWrap::ModifyRequest(vtkInformation* request, int when)
{
  AbortFlag::Keep(this, request, when);
  this->WholeInput->Exchange(this, request, when);
  return this->Superclass::ModifyRequest(request, when);
}

//------------------------------------------------------------------------------
int vtkShrinkWrap::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  if (this->OutputSteps)
  {
    InputStep{ this->InputTime, this->InputTimeIndex }.Request(input);
  }
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
    EvolutionArrays::WriteEmpty(
      output, true, [input, output]() { DataTransfer::CopyWithoutTuples(input, output); });
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
  vtkInformation* inputInformation = inputVector[0]->GetInformationObject(0);
  return KernelBridge::RunToOutputs(this, { output, history },
    [&](const evolving::Execution& execution)
    {
      if (this->OutputSteps)
      {
        InputStep{ this->InputTime, this->InputTimeIndex }.Require(inputInformation);
      }
      this->Solved->Check({ input }, this->Options());
      if (!this->Solved->Series)
      {
        this->Solve(input, execution);
      }
      this->WriteState(step, input, output, execution);
      this->Solved->Series->WriteHistory(history);
      if (this->OutputSteps)
      {
        InputStep::Write(inputInformation, output);
        TimeSteps::Mark(output, times[step]);
      }
    });
}

//------------------------------------------------------------------------------
void vtkShrinkWrap::WriteState(
  std::size_t step, vtkPolyData* input, vtkPolyData* output, const evolving::Execution& execution)
{
  this->Solved->Misfits.Say(this, input);
  this->Solved->Series->WriteState(step, output, execution,
    [&](const evolving::FlowState& state) { this->WriteData(input, state, output, execution); });
  if (step + 1 == this->Times().size())
  {
    WrapReport::Write(this->Solved->Report, this->Solved->Shortcomings, output);
  }
}

//------------------------------------------------------------------------------
void vtkShrinkWrap::WriteData(vtkPolyData* input, const evolving::FlowState& state,
  vtkPolyData* output, const evolving::Execution& execution)
{
  DataTransfer::PassFieldData(input, output);
  const bool hasPointData =
    this->PassPointData && CarriedArrays::OfPoints(input)->GetNumberOfArrays() > 0;
  const bool hasCellData =
    this->PassCellData && CarriedArrays::OfCells(input)->GetNumberOfArrays() > 0;
  std::unique_ptr<const ClosestElements>& closest = this->Solved->Closest;
  if ((hasPointData || hasCellData) && !closest)
  {
    const auto target = KernelBridge::ReadUsable(input, execution.phase(1.0, 1.0));
    closest = std::make_unique<const ClosestElements>(
      target.mesh, target.pointOfVertex, target.cellOfFace, execution.phase(1.0, 1.0));
  }
  if (hasPointData)
  {
    DataTransfer::InterpolatePoints(
      input, closest->MixturesAt(state.points, execution.phase(1.0, 1.0)), output);
  }
  if (hasCellData)
  {
    const auto middles = FaceCenters(*state.origin, state.points);
    DataTransfer::CopyCells(input, closest->CellsAt(middles, execution.phase(1.0, 1.0)), output);
  }
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
  this->Solved->Closest.reset();
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
  os << indent << "InputTime: " << this->InputTime << "\n";
  os << indent << "InputTimeIndex: " << this->InputTimeIndex << "\n";
  os << indent << "PassPointData: " << this->PassPointData << "\n";
  os << indent << "PassCellData: " << this->PassCellData << "\n";
  os << indent << "NumberOfSolves: " << this->NumberOfSolves << "\n";
}
