// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurfaceEvolution.h"

#include "AbortFlag.h"
#include "CarriedArrays.h"
#include "DataTransfer.h"
#include "DistributedInput.h"
#include "EvolutionCache.h"
#include "EvolutionOutput.h"
#include "EvolutionStart.h"
#include "ImageArray.h"
#include "InputStep.h"
#include "KernelBridge.h"
#include "TimeSteps.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <string>
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkSurfaceEvolution);

namespace
{

//------------------------------------------------------------------------------
std::size_t Bytes(int mebibytes)
{
  return static_cast<std::size_t>(mebibytes) << 20;
}

} // namespace

//------------------------------------------------------------------------------
/// Of the flow's options, those of remeshing, OutputInterval and CacheLimit.
struct vtkSurfaceEvolution::Cache
  : EvolutionCache<
      std::tuple<evolving::FlowOptions, std::optional<evolving::SurfaceRemeshingOptions>, int, int>>
{
  std::unique_ptr<EvolutionStart> Start;
  MisfitWarning Misfits;
  std::vector<std::string> Shortcomings; ///< of the last state, a sentence each
};

//------------------------------------------------------------------------------
vtkSurfaceEvolution::vtkSurfaceEvolution()
  : Solved(std::make_unique<Cache>())
  , WholeInput(std::make_unique<DistributedInput>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->FieldArray = std::make_unique<ImageArray>(this, 1);
}

//------------------------------------------------------------------------------
vtkSurfaceEvolution::~vtkSurfaceEvolution() = default;

//------------------------------------------------------------------------------
int vtkSurfaceEvolution::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceEvolution::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
evolving::FlowOptions vtkSurfaceEvolution::Options() const
{
  evolving::FlowOptions options;
  options.timeStep = this->TimeStep;
  options.numberOfSteps = this->NumberOfSteps;
  options.flow = static_cast<evolving::Flow>(this->Flow);
  options.volumePreserving = this->VolumePreserving;
  options.curvatureSpeed = this->CurvatureSpeed;
  options.curvatureRange = this->CurvatureRange;
  options.advectionSpeed = this->AdvectionSpeed;
  options.advectionBalance = this->AdvectionBalance;
  options.relativeUnits = this->RelativeUnits;
  options.fieldMode = static_cast<evolving::FieldMode>(this->FieldMode);
  options.edgeSharpness = this->EdgeSharpness;
  options.normalSpeed = this->NormalSpeed;
  options.redistribution.volume = this->VolumeRedistribution;
  options.redistribution.angle = this->AngleRedistribution;
  options.redistribution.length = this->LengthRedistribution;
  options.redistribution.angleMethod = static_cast<evolving::AngleMethod>(this->AngleMethod);
  options.redistribution.angleWeighting =
    static_cast<evolving::AngleWeighting>(this->AngleWeighting);
  options.redistribution.curvatureControl =
    static_cast<evolving::CurvatureControl>(this->CurvatureControl);
  options.redistribution.curvatureControlAlpha = this->CurvatureControlAlpha;
  options.smoothingSteps = this->SmoothingSteps;
  options.smoothingSpeed = this->SmoothingSpeed;
  options.smoothingDecay = this->SmoothingDecay;
  options.boundaryMode = static_cast<evolving::BoundaryMode>(this->BoundaryMode);
  options.surfaceGuard = this->SurfaceGuard;
  options.convergenceTolerance = this->ConvergenceTolerance;
  options.remeshingInterval = this->RemeshingInterval;
  options.solverTolerance = this->SolverTolerance;
  return options;
}

//------------------------------------------------------------------------------
/// None when elements stay as they are.
std::optional<evolving::SurfaceRemeshingOptions> vtkSurfaceEvolution::RemeshingOptions() const
{
  if (this->Remeshing == OFF)
  {
    return std::nullopt;
  }
  evolving::SurfaceRemeshingOptions options;
  options.onlyDegenerate = this->Remeshing == AUTOMATIC;
  options.sizing = this->Remeshing == CURVATURE_ADAPTIVE
    ? evolving::ElementSizing::CurvatureAdaptive
    : evolving::ElementSizing::Uniform;
  options.edgeLength = this->TargetEdgeLength;
  options.boundaryMode = static_cast<evolving::BoundaryMode>(this->BoundaryMode);
  return options;
}

//------------------------------------------------------------------------------
/// Times are published before there is data to choose a step from: then they count steps.
double vtkSurfaceEvolution::PublishedTimeStep() const
{
  return this->TimeStep > 0.0 ? this->TimeStep : 1.0;
}

//------------------------------------------------------------------------------
int vtkSurfaceEvolution::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const auto published =
    evolving::publishedIterations(this->NumberOfSteps, this->SmoothingSteps, this->OutputInterval);
  TimeSteps::Publish(
    outputVector->GetInformationObject(0), TimeSteps::Times(published, this->PublishedTimeStep()));
  TimeSteps::Remove(outputVector->GetInformationObject(1));
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceEvolution::ModifyRequest(vtkInformation* request, int when)
{
  AbortFlag::Keep(this, request, when);
  this->WholeInput->Exchange(this, request, when);
  return this->Superclass::ModifyRequest(request, when);
}

//------------------------------------------------------------------------------
int vtkSurfaceEvolution::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* surface = inputVector[0]->GetInformationObject(0);
  const InputStep inputs{ this->InputTime, this->InputTimeIndex };
  inputs.Request(surface);
  this->WholeInput->RequestSurface(surface);
  if (vtkInformation* field = inputVector[1]->GetInformationObject(0))
  {
    KernelBridge::RequestWholeImage(field);
    inputs.Request(field);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceEvolution::RequestData(
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
    EvolutionArrays::WriteEmpty(output, vtkImageData::GetData(inputVector[1]) != nullptr,
      [input, output]() { DataTransfer::CopyWithoutTuples(input, output); });
    EvolutionArrays::WriteEmptyHistory(history);
    return 1;
  }
  if (!input || !KernelBridge::HasFaces(input))
  {
    return KernelBridge::RefuseUnlessEmpty(this, input);
  }
  return KernelBridge::RunToOutputs(this, { output, history },
    [&](const evolving::Execution& execution)
    {
      this->UpdateSeries(input, inputVector, execution);
      this->WriteState(input, outputVector, execution);
      InputStep::Write(inputVector[0]->GetInformationObject(0), output);
      this->Solved->Series->WriteHistory(history);
    });
}

//------------------------------------------------------------------------------
/// Solves the flow, unless the last one is of the same inputs and parameters.
void vtkSurfaceEvolution::UpdateSeries(
  vtkPolyData* input, vtkInformationVector** inputVector, const evolving::Execution& execution)
{
  for (int port = 0; port < 2; ++port)
  {
    if (vtkInformation* information = inputVector[port]->GetInformationObject(0))
    {
      InputStep{ this->InputTime, this->InputTimeIndex }.Require(information);
    }
  }
  vtkImageData* field = this->FieldArray->Get(this, inputVector);
  evolving::FlowOptions options = this->Options();
  options.tracesStart = this->Remeshing != OFF && CarriedArrays::HasAny(input);
  Cache& cache = *this->Solved;
  cache.Check({ input, field },
    { options, this->RemeshingOptions(), this->OutputInterval, this->CacheLimit });
  if (!cache.Series)
  {
    cache.Series = this->Solve(input, field, options, execution);
  }
  cache.Misfits.Say(this, input);
}

//------------------------------------------------------------------------------
/// The state that the update asks for.
void vtkSurfaceEvolution::WriteState(
  vtkPolyData* input, vtkInformationVector* outputVector, const evolving::Execution& execution)
{
  Cache& cache = *this->Solved;
  // They may end earlier than published before: where the surface has shrunk to a point.
  const auto times = TimeSteps::Times(cache.Series->Flow().iterations(), this->PublishedTimeStep());
  vtkInformation* information = outputVector->GetInformationObject(0);
  if (cache.Series->Flow().extinctionTime())
  {
    TimeSteps::Publish(information, times);
  }
  const std::size_t step = TimeSteps::Requested(information, times);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  cache.Series->WriteState(step, output, execution,
    [&](const evolving::FlowState& state)
    {
      DataTransfer::PassFieldData(input, output);
      cache.Start->WriteData(input, state, output, execution);
    });
  CarriedArrays::RenewNormals(input, output);
  KernelBridge::AddFieldValue(output, "TimeStep", cache.Series->Flow().timeStep());
  if (const double sharpness = cache.Series->Flow().edgeSharpness())
  {
    KernelBridge::AddFieldValue(output, "EdgeSharpness", sharpness);
  }
  if (!cache.Shortcomings.empty())
  {
    KernelBridge::AddFieldStrings(output, "Shortcomings", cache.Shortcomings);
  }
  TimeSteps::Mark(output, times[step]);
}

//------------------------------------------------------------------------------
std::unique_ptr<EvolutionOutput> vtkSurfaceEvolution::Solve(vtkPolyData* input, vtkImageData* field,
  const evolving::FlowOptions& options, const evolving::Execution& execution)
{
  const bool isSplit = this->Remeshing != OFF && this->Remeshing != AUTOMATIC;
  this->Solved->Start = std::make_unique<EvolutionStart>(input, isSplit, execution.phase(0.0, 0.0));
  auto remeshing = this->RemeshingOptions();
  if (remeshing)
  {
    remeshing->keepsStart = !this->Solved->Start->TakeSliversOut();
  }
  const auto start = this->Solved->Start->Mesh();
  std::shared_ptr<const evolving::ScalarImage> image;
  if (field)
  {
    image = std::make_shared<const evolving::ScalarImage>(KernelBridge::ReadImage(field));
    evolving::checkField(*image, *start, options.fieldMode);
  }
  std::shared_ptr<evolving::Remesher> remesher;
  if (remeshing)
  {
    // An open surface comes to cover a piece of the zero level, nobody knows how large a one.
    const bool hasTarget = image && options.fieldMode == evolving::FieldMode::DistanceField &&
      evolving::summarizeTopology(*start).isClosed();
    remeshing->targetArea = hasTarget ? evolving::zeroLevelArea(*image) : 0.0;
    remesher = std::make_shared<evolving::SurfaceRemesher>(*start, *remeshing);
  }
  const std::size_t imageBytes = image ? image->values().size() * sizeof(float) : 0;
  ++this->NumberOfSolves;
  // Volumes that are held to 1e-12 are not to be rounded away.
  const int pointType = options.holdsVolume() ? VTK_DOUBLE : KernelBridge::PointType(input);
  auto series = std::make_unique<EvolutionOutput>(
    pointType, image != nullptr,
    [start, image, remesher, options](const evolving::Execution& host)
    { return evolving::SurfaceFlow(start, image, remesher, options, host); },
    evolving::publishedIterations(this->NumberOfSteps, this->SmoothingSteps, this->OutputInterval),
    Bytes(this->CacheLimit), execution, imageBytes);
  if (series->PointType() != pointType)
  {
    KernelBridge::WarnOfDoubles(this);
  }
  this->WarnOfEnd(image.get(), options, *series, execution);
  return series;
}

//------------------------------------------------------------------------------
/// Says what of the flow's end is not as a user would expect.
void vtkSurfaceEvolution::WarnOfEnd(const evolving::ScalarImage* field,
  const evolving::FlowOptions& options, EvolutionOutput& series,
  const evolving::Execution& execution)
{
  const evolving::StateSeries& flow = series.Flow();
  if (const int steps = flow.stepsWithoutRedistribution())
  {
    vtkWarningMacro(
      "The volume-based redistribution has no potential on degenerate elements, as at a "
      "neck that pinches off: "
      << steps << " of " << flow.lastIteration()
      << " steps went without it, expected none; switch Remeshing on.");
  }
  this->Solved->Shortcomings.clear();
  if (field && options.fieldMode == evolving::FieldMode::DistanceField)
  {
    const auto last = series.LastState(execution.phase(1.0, 1.0));
    const std::string left = evolving::unreachedInWords(*field, *last,
      flow.history().front().maxDistance, options.advectionSpeed, execution.phase(1.0, 1.0));
    if (!left.empty())
    {
      vtkWarningMacro(<< left);
      this->Solved->Shortcomings.push_back(left);
    }
  }
  if (!flow.stopReason().empty())
  {
    vtkErrorMacro(<< flow.stopReason());
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceEvolution::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "OutputInterval: " << this->OutputInterval << "\n";
  os << indent << "Flow: " << this->Flow << "\n";
  os << indent << "VolumePreserving: " << this->VolumePreserving << "\n";
  os << indent << "CurvatureSpeed: " << this->CurvatureSpeed << "\n";
  os << indent << "CurvatureRange: " << this->CurvatureRange << "\n";
  os << indent << "AdvectionSpeed: " << this->AdvectionSpeed << "\n";
  os << indent << "AdvectionBalance: " << this->AdvectionBalance << "\n";
  os << indent << "RelativeUnits: " << this->RelativeUnits << "\n";
  os << indent << "FieldMode: " << this->FieldMode << "\n";
  os << indent << "EdgeSharpness: " << this->EdgeSharpness << "\n";
  os << indent << "NormalSpeed: " << this->NormalSpeed << "\n";
  os << indent << "VolumeRedistribution: " << this->VolumeRedistribution << "\n";
  os << indent << "AngleRedistribution: " << this->AngleRedistribution << "\n";
  os << indent << "LengthRedistribution: " << this->LengthRedistribution << "\n";
  os << indent << "AngleMethod: " << this->AngleMethod << "\n";
  os << indent << "AngleWeighting: " << this->AngleWeighting << "\n";
  os << indent << "CurvatureControl: " << this->CurvatureControl << "\n";
  os << indent << "CurvatureControlAlpha: " << this->CurvatureControlAlpha << "\n";
  os << indent << "SmoothingSteps: " << this->SmoothingSteps << "\n";
  os << indent << "SmoothingSpeed: " << this->SmoothingSpeed << "\n";
  os << indent << "SmoothingDecay: " << this->SmoothingDecay << "\n";
  os << indent << "BoundaryMode: " << this->BoundaryMode << "\n";
  os << indent << "SurfaceGuard: " << this->SurfaceGuard << "\n";
  os << indent << "ConvergenceTolerance: " << this->ConvergenceTolerance << "\n";
  os << indent << "Remeshing: " << this->Remeshing << "\n";
  os << indent << "TargetEdgeLength: " << this->TargetEdgeLength << "\n";
  os << indent << "RemeshingInterval: " << this->RemeshingInterval << "\n";
  os << indent << "SolverTolerance: " << this->SolverTolerance << "\n";
  os << indent << "InputTime: " << this->InputTime << "\n";
  os << indent << "InputTimeIndex: " << this->InputTimeIndex << "\n";
  os << indent << "CacheLimit: " << this->CacheLimit << "\n";
  os << indent << "NumberOfSolves: " << this->NumberOfSolves << "\n";
}
