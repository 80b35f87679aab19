// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurfaceEvolution.h"

#include "DistributedInput.h"
#include "EvolutionCache.h"
#include "EvolutionOutput.h"
#include "KernelBridge.h"
#include "TimeSteps.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <tuple>

vtkStandardNewMacro(vtkSurfaceEvolution);

namespace
{

//------------------------------------------------------------------------------
std::size_t Bytes(int mebibytes)
{
  return static_cast<std::size_t>(mebibytes) << 20;
}

//------------------------------------------------------------------------------
/// The input welded and, where it is closed, with normals outwards: contour filters turn them to
/// lower values, which is inwards for a signed distance.
evolving::SurfaceMesh StartSurface(const KernelBridge::Surface& surface)
{
  const evolving::SurfaceMesh start = evolving::weldCoincidentPoints(surface.mesh);
  const bool isInsideOut =
    evolving::summarizeTopology(start).isClosed() && evolving::signedVolume(start) < 0.0;
  return isInsideOut ? evolving::reversed(start) : start;
}

} // namespace

//------------------------------------------------------------------------------
/// Of the flow's options, those of remeshing, OutputInterval and CacheLimit.
struct vtkSurfaceEvolution::Cache
  : EvolutionCache<
      std::tuple<evolving::FlowOptions, std::optional<evolving::SurfaceRemeshingOptions>, int, int>>
{
};

//------------------------------------------------------------------------------
vtkSurfaceEvolution::vtkSurfaceEvolution()
  : Solved(std::make_unique<Cache>())
  , WholeInput(std::make_unique<DistributedInput>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
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
  options.curvatureSpeed = this->CurvatureSpeed;
  options.curvatureRange = this->CurvatureRange;
  options.advectionSpeed = this->AdvectionSpeed;
  options.advectionBalance = this->AdvectionBalance;
  options.relativeUnits = this->RelativeUnits;
  options.fieldMode = static_cast<evolving::FieldMode>(this->FieldMode);
  options.edgeSharpness = this->EdgeSharpness;
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
  this->WholeInput->Exchange(this, request, when);
  return this->Superclass::ModifyRequest(request, when);
}

//------------------------------------------------------------------------------
int vtkSurfaceEvolution::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkInformation* surface = inputVector[0]->GetInformationObject(0);
  TimeSteps::RequestLastStep(surface);
  this->WholeInput->RequestSurface(surface);
  if (vtkInformation* field = inputVector[1]->GetInformationObject(0))
  {
    KernelBridge::RequestWholeImage(field);
    TimeSteps::RequestLastStep(field);
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
  vtkImageData* field = vtkImageData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* history = vtkTable::GetData(outputVector, 1);
  if (!KernelBridge::WritesGeometry(request, outputVector))
  {
    EvolutionArrays::WriteEmpty(output, field != nullptr);
    EvolutionArrays::WriteEmptyHistory(history);
    return 1;
  }
  if (!input || !KernelBridge::HasFaces(input))
  {
    return KernelBridge::RefuseUnlessEmpty(this, input);
  }
  const auto published =
    evolving::publishedIterations(this->NumberOfSteps, this->SmoothingSteps, this->OutputInterval);
  Cache& cache = *this->Solved;
  cache.Check({ input, field },
    { this->Options(), this->RemeshingOptions(), this->OutputInterval, this->CacheLimit });
  return KernelBridge::RunToOutputs(this, { output, history },
    [&](const evolving::Execution& execution)
    {
      if (!cache.Series)
      {
        cache.Series = this->Solve(input, field, published, execution);
      }
      // They may end earlier than published before: where the surface has shrunk to a point.
      const auto times =
        TimeSteps::Times(cache.Series->Flow().iterations(), this->PublishedTimeStep());
      vtkInformation* information = outputVector->GetInformationObject(0);
      if (cache.Series->Flow().extinctionTime())
      {
        TimeSteps::Publish(information, times);
      }
      const std::size_t step = TimeSteps::Requested(information, times);
      cache.Series->WriteState(step, output, execution);
      KernelBridge::AddFieldValue(output, "TimeStep", cache.Series->Flow().timeStep());
      cache.Series->WriteHistory(history);
      TimeSteps::Mark(output, times[step]);
    });
}

//------------------------------------------------------------------------------
std::unique_ptr<EvolutionOutput> vtkSurfaceEvolution::Solve(vtkPolyData* input, vtkImageData* field,
  const std::vector<int>& published, const evolving::Execution& execution)
{
  const auto start = std::make_shared<const evolving::SurfaceMesh>(
    StartSurface(this->Remeshing == OFF || this->Remeshing == AUTOMATIC
        ? KernelBridge::ReadSurface(input)
        : KernelBridge::ReadTriangles(input, execution.phase(0.0, 0.0))));
  std::shared_ptr<const evolving::ScalarImage> image;
  if (field)
  {
    image = std::make_shared<const evolving::ScalarImage>(KernelBridge::ReadImage(field));
  }
  const evolving::FlowOptions options = this->Options();
  std::shared_ptr<evolving::Remesher> remesher;
  if (const auto remeshing = this->RemeshingOptions())
  {
    remesher = std::make_shared<evolving::SurfaceRemesher>(*start, *remeshing);
  }
  const std::size_t imageBytes = image ? image->values().size() * sizeof(float) : 0;
  ++this->NumberOfSolves;
  auto series = std::make_unique<EvolutionOutput>(
    KernelBridge::PointType(input), image != nullptr,
    [start, image, remesher, options](const evolving::Execution& host)
    { return evolving::SurfaceFlow(start, image, remesher, options, host); },
    published, Bytes(this->CacheLimit), execution, imageBytes);
  if (series->PointType() != KernelBridge::PointType(input))
  {
    KernelBridge::WarnOfDoubles(this);
  }
  if (!series->Flow().stopReason().empty())
  {
    vtkErrorMacro(<< series->Flow().stopReason());
  }
  return series;
}

//------------------------------------------------------------------------------
void vtkSurfaceEvolution::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "OutputInterval: " << this->OutputInterval << "\n";
  os << indent << "CurvatureSpeed: " << this->CurvatureSpeed << "\n";
  os << indent << "CurvatureRange: " << this->CurvatureRange << "\n";
  os << indent << "AdvectionSpeed: " << this->AdvectionSpeed << "\n";
  os << indent << "AdvectionBalance: " << this->AdvectionBalance << "\n";
  os << indent << "RelativeUnits: " << this->RelativeUnits << "\n";
  os << indent << "FieldMode: " << this->FieldMode << "\n";
  os << indent << "EdgeSharpness: " << this->EdgeSharpness << "\n";
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
  os << indent << "CacheLimit: " << this->CacheLimit << "\n";
  os << indent << "NumberOfSolves: " << this->NumberOfSolves << "\n";
}
