// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLabelSurfaces.h"

#include "AbortFlag.h"
#include "ImageArray.h"
#include "KernelBridge.h"
#include "LabelOutput.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkLabelSurfaces);

namespace
{

/// More than a thousandth is worth a sentence: a hundredth is what is promised.
constexpr double NotableVolumeError = 1e-3;

} // namespace

//------------------------------------------------------------------------------
vtkLabelSurfaces::vtkLabelSurfaces()
  : LabelArray(std::make_unique<ImageArray>(this, 0, "labels"))
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkLabelSurfaces::~vtkLabelSurfaces() = default;

//------------------------------------------------------------------------------
void vtkLabelSurfaces::AddLabel(double label)
{
  if (std::find(this->Labels.begin(), this->Labels.end(), label) == this->Labels.end())
  {
    this->Labels.push_back(label);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkLabelSurfaces::RemoveAllLabels()
{
  if (!this->Labels.empty())
  {
    this->Labels.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkLabelSurfaces::GetLabel(int number) const
{
  const bool isOne = number >= 0 && number < this->GetNumberOfLabels();
  return isOne ? this->Labels[static_cast<std::size_t>(number)] : 0.0;
}

//------------------------------------------------------------------------------
int vtkLabelSurfaces::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkLabelSurfaces::ModifyRequest(vtkInformation* request, int when)
{
  AbortFlag::Keep(this, request, when);
  return this->Superclass::ModifyRequest(request, when);
}

//------------------------------------------------------------------------------
int vtkLabelSurfaces::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  KernelBridge::RequestWholeImage(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkLabelSurfaces::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkPolyData* surfaces = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* interfaces = vtkPolyData::GetData(outputVector, 1);
  if (!input || input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  return KernelBridge::RunToOutputs(this, { surfaces, interfaces },
    [&](const evolving::Execution& execution)
    {
      vtkImageData* image = this->LabelArray->Get(this, inputVector);
      const int type = image->GetPointData()->GetScalars()->GetDataType();
      if (!KernelBridge::WritesGeometry(request, outputVector))
      {
        const LabelOutput output(type, this->BackgroundLabel, {});
        output.WriteSurfaces({}, surfaces);
        output.WriteInterfaces({}, interfaces);
        return;
      }
      const KernelBridge::Labels labels = KernelBridge::ReadLabels(
        image, { this->Labels, this->BackgroundLabel }, execution.phase(0.0, 0.05));
      const evolving::LabelSurfaces result = evolving::labelSurfaces(
        labels.image, { this->SmoothingLength }, execution.phase(0.05, 0.95));
      const LabelOutput output(type, this->BackgroundLabel, labels.values);
      output.WriteSurfaces(result, surfaces);
      output.WriteInterfaces(result, interfaces);
      execution.report(1.0);
      if (result.largestVolumeError > NotableVolumeError)
      {
        vtkWarningMacro(
          << "The volume of a label is off by " << 100.0 * result.largestVolumeError
          << " % of its voxels' (Volume, VoxelVolume): half a voxel leaves its points "
             "no way to where it would be right; a smaller SmoothingLength helps.");
      }
    });
}

//------------------------------------------------------------------------------
void vtkLabelSurfaces::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Labels:";
  for (const double label : this->Labels)
  {
    os << " " << label;
  }
  os << (this->Labels.empty() ? " all but the background\n" : "\n");
  os << indent << "BackgroundLabel: " << this->BackgroundLabel << "\n";
  os << indent << "SmoothingLength: " << this->SmoothingLength << "\n";
}
