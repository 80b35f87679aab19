// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMeshSDF.h"

#include "AbortFlag.h"
#include "DistanceImage.h"
#include "DistributedInput.h"
#include "KernelBridge.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <vector>

vtkStandardNewMacro(vtkMeshSDF);

namespace
{

constexpr int LargestDimension = 65536;

//------------------------------------------------------------------------------
evolving::Extent RequestedExtent(vtkInformation* request)
{
  evolving::Extent extent;
  request->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
  return extent;
}

//------------------------------------------------------------------------------
/// The input as the kernel wants it: triangles, or a point set whose "cells" are its points.
KernelBridge::Surface ReadInput(vtkPolyData* input, const evolving::Execution& execution)
{
  if (KernelBridge::HasFaces(input))
  {
    return KernelBridge::ReadTriangles(input, execution);
  }
  return KernelBridge::ReadPointSet(input);
}

} // namespace

//------------------------------------------------------------------------------
vtkMeshSDF::vtkMeshSDF()
  : WholeInput(std::make_unique<DistributedInput>())
{
  this->SetNumberOfInputPorts(1);
}

//------------------------------------------------------------------------------
vtkMeshSDF::~vtkMeshSDF() = default;

//------------------------------------------------------------------------------
void vtkMeshSDF::SetSampleDimensions(int x, int y, int z)
{
  const int dimensions[3] = { x, y, z };
  this->SetSampleDimensions(dimensions);
}

//------------------------------------------------------------------------------
void vtkMeshSDF::SetSampleDimensions(const int dimensions[3])
{
  if (KernelBridge::AssignClamped(dimensions, 1, LargestDimension, this->SampleDimensions))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkMeshSDF::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
evolving::SignedDistanceOptions vtkMeshSDF::Options() const
{
  evolving::SignedDistanceOptions options;
  options.method = static_cast<evolving::DistanceMethod>(this->Method);
  options.sign = static_cast<evolving::SignMethod>(this->Sign);
  options.bandWidth = this->BandWidth;
  options.smoothingSigma = this->SmoothingSigma;
  options.numberOfSweeps = this->NumberOfSweeps;
  options.closestPoint = this->ComputeClosestPoint;
  options.closestFace = this->ComputeClosestCellId;
  options.gradient = this->ComputeGradient;
  return options;
}

//------------------------------------------------------------------------------
evolving::DistanceGrid vtkMeshSDF::GridFor(const evolving::SurfaceMesh& mesh) const
{
  return KernelBridge::MakeGrid(
    evolving::boundingBox(mesh), this->SampleDimensions, this->ModelBounds, this->Padding);
}

//------------------------------------------------------------------------------
void vtkMeshSDF::PublishGrid(vtkInformation* info) const
{
  try
  {
    const evolving::DistanceGrid grid = this->GridFor({});
    info->Set(vtkDataObject::ORIGIN(), grid.origin.data(), 3);
    info->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
  }
  catch (const evolving::InputError&)
  {
    // Bounds that are no box: RequestData says so, once, and leaves the output empty.
  }
}

//------------------------------------------------------------------------------
int vtkMeshSDF::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  const int* n = this->SampleDimensions;
  const int extent[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetActiveAttributeInfo(info, vtkDataObject::FIELD_ASSOCIATION_POINTS,
    vtkDataSetAttributes::SCALARS, "SignedDistance", VTK_FLOAT, 1, -1);
  // Automatic bounds depend on data that are not there yet; then the data alone say where.
  info->Remove(vtkDataObject::ORIGIN());
  info->Remove(vtkDataObject::SPACING());
  if (!KernelBridge::IsAutomatic(this->ModelBounds))
  {
    this->PublishGrid(info);
  }
  // Also where the method needs the whole grid: it hands out the part that is asked for, so that
  // several ranks do not all draw everything.
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshSDF::ModifyRequest(vtkInformation* request, int when)
{
  AbortFlag::Keep(this, request, when);
  this->WholeInput->Exchange(this, request, when);
  return this->Superclass::ModifyRequest(request, when);
}

//------------------------------------------------------------------------------
int vtkMeshSDF::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  this->WholeInput->RequestSurface(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshSDF::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (this->WholeInput->IsRefused())
  {
    return 0;
  }
  vtkPolyData* input = this->WholeInput->Surface(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  const evolving::Extent part = RequestedExtent(outputVector->GetInformationObject(0));
  output->Initialize();
  if (!input || input->GetNumberOfPoints() == 0 || part[0] > part[1] || part[2] > part[3] ||
    part[4] > part[5])
  {
    return 1;
  }
  return KernelBridge::RunToOutputs(this, { output },
    [&](const evolving::Execution& execution)
    {
      KernelBridge::Surface surface = ReadInput(input, execution.phase(0.0, 0.0));
      this->WholeInput->NameCells(surface.cellOfFace);
      const evolving::DistanceGrid grid = this->GridFor(surface.mesh);
      evolving::requireDistancesForFloats(evolving::boundingBox(surface.mesh), grid);
      const evolving::SignedDistanceOptions options = this->Options();
      const evolving::Extent computed = evolving::canComputeParts(options) ? part : grid.extent;
      KernelBridge::RequireMemory(grid.part(computed).sampleCount(), options);
      const auto result = evolving::signedDistance(surface.mesh, grid, part, options, execution);
      DistanceImage::Write(grid, part, result, surface.cellOfFace, output);
    });
}

//------------------------------------------------------------------------------
void vtkMeshSDF::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const int* n = this->SampleDimensions;
  const double* b = this->ModelBounds;
  os << indent << "SampleDimensions: " << n[0] << " " << n[1] << " " << n[2] << "\n";
  os << indent << "Padding: " << this->Padding << "\n";
  os << indent << "ModelBounds: " << b[0] << " " << b[1] << " " << b[2] << " " << b[3] << " "
     << b[4] << " " << b[5] << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Sign: " << this->Sign << "\n";
  os << indent << "BandWidth: " << this->BandWidth << "\n";
  os << indent << "SmoothingSigma: " << this->SmoothingSigma << "\n";
  os << indent << "NumberOfSweeps: " << this->NumberOfSweeps << "\n";
  os << indent << "ComputeClosestPoint: " << this->ComputeClosestPoint << "\n";
  os << indent << "ComputeClosestCellId: " << this->ComputeClosestCellId << "\n";
  os << indent << "ComputeGradient: " << this->ComputeGradient << "\n";
}
