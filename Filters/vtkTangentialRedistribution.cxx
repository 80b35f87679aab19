// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTangentialRedistribution.h"

#include "AbortFlag.h"
#include "CarriedArrays.h"
#include "DistributedInput.h"
#include "EvolutionOutput.h"
#include "KernelBridge.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkTangentialRedistribution);

namespace
{

//------------------------------------------------------------------------------
/// Nor may an element turn over when its points become floats.
bool FloatsKeepElements(
  const evolving::SurfaceRedistributionResult& result, const evolving::Execution& execution)
{
  evolving::SurfaceMesh rounded = result.mesh;
  rounded.points = evolving::roundedToFloats(result.mesh.points);
  const std::vector<char> spoiled = evolving::spoiledElements(
    rounded, result.mesh.points, result.arrays.normal, 0.0, execution.phase(1.0, 1.0));
  return evolving::floatsHold(result.mesh) &&
    std::find(spoiled.begin(), spoiled.end(), 1) == spoiled.end();
}

} // namespace

//------------------------------------------------------------------------------
vtkTangentialRedistribution::vtkTangentialRedistribution()
  : WholeInput(std::make_unique<DistributedInput>())
{
}

//------------------------------------------------------------------------------
vtkTangentialRedistribution::~vtkTangentialRedistribution() = default;

//------------------------------------------------------------------------------
evolving::SurfaceRedistributionOptions vtkTangentialRedistribution::Options() const
{
  evolving::SurfaceRedistributionOptions options;
  options.numberOfSteps = this->NumberOfSteps;
  options.timeStep = this->TimeStep;
  options.redistribution.volume = this->VolumeRedistribution;
  options.redistribution.angle = this->AngleRedistribution;
  options.redistribution.length = this->LengthRedistribution;
  options.redistribution.angleMethod = static_cast<evolving::AngleMethod>(this->AngleMethod);
  options.redistribution.angleWeighting =
    static_cast<evolving::AngleWeighting>(this->AngleWeighting);
  options.redistribution.curvatureControl =
    static_cast<evolving::CurvatureControl>(this->CurvatureControl);
  options.redistribution.curvatureControlAlpha = this->CurvatureControlAlpha;
  options.preserveShape = this->PreserveShape;
  options.boundaryMode = static_cast<evolving::BoundaryMode>(this->BoundaryMode);
  options.featureAngle = this->FeatureAngle;
  return options;
}

//------------------------------------------------------------------------------
int vtkTangentialRedistribution::ModifyRequest(vtkInformation* request, int when)
{
  AbortFlag::Keep(this, request, when);
  this->WholeInput->Exchange(this, request, when);
  return this->Superclass::ModifyRequest(request, when);
}

//------------------------------------------------------------------------------
int vtkTangentialRedistribution::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  this->WholeInput->RequestSurface(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkTangentialRedistribution::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->WholeInput->IsRefused())
  {
    return 0;
  }
  vtkPolyData* input = this->WholeInput->Surface(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!KernelBridge::WritesGeometry(request, outputVector))
  {
    KernelBridge::CopyWithoutTuples(input, output);
    CarriedArrays::RemoveNormals(output);
    EvolutionArrays::WriteShapeArrays({}, output);
    return 1;
  }
  if (!input || !KernelBridge::HasFaces(input))
  {
    return KernelBridge::RefuseUnlessEmpty(this, input);
  }
  return KernelBridge::RunToOutputs(this, { output },
    [&](const evolving::Execution& execution)
    {
      const KernelBridge::WeldedSurface surface = KernelBridge::ReadWelded(input);
      const evolving::SurfaceRedistributionResult result =
        evolving::redistributeSurface(surface.mesh, this->Options(), execution);
      output->ShallowCopy(input);
      CarriedArrays::RemoveNormals(output);
      const int wanted = KernelBridge::PointType(input);
      const bool areHeld = wanted == VTK_DOUBLE || FloatsKeepElements(result, execution);
      KernelBridge::MoveWeldedPoints(
        surface, result.mesh.points, areHeld ? wanted : VTK_DOUBLE, output);
      if (!areHeld)
      {
        KernelBridge::WarnOfDoubles(this);
      }
      EvolutionArrays::WriteShapeArrays(KernelBridge::Unweld(surface, result.arrays), output);
      CarriedArrays::RenewNormals(input, output);
    });
}

//------------------------------------------------------------------------------
void vtkTangentialRedistribution::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "VolumeRedistribution: " << this->VolumeRedistribution << "\n";
  os << indent << "AngleRedistribution: " << this->AngleRedistribution << "\n";
  os << indent << "LengthRedistribution: " << this->LengthRedistribution << "\n";
  os << indent << "AngleMethod: " << this->AngleMethod << "\n";
  os << indent << "AngleWeighting: " << this->AngleWeighting << "\n";
  os << indent << "CurvatureControl: " << this->CurvatureControl << "\n";
  os << indent << "CurvatureControlAlpha: " << this->CurvatureControlAlpha << "\n";
  os << indent << "PreserveShape: " << this->PreserveShape << "\n";
  os << indent << "BoundaryMode: " << this->BoundaryMode << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
}
