// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkIcosphereSource.h"

#include "KernelBridge.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkIcosphereSource);

//------------------------------------------------------------------------------
vtkIcosphereSource::vtkIcosphereSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
int vtkIcosphereSource::RequestData(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (!KernelBridge::WritesGeometry(request, outputVector))
  {
    return 1;
  }
  return KernelBridge::RunToOutputs(this, { output },
    [&](const evolving::Execution&)
    {
      const evolving::Vec3 center(this->Center);
      const evolving::SurfaceMesh mesh = this->Shape == ICOSPHERE
        ? evolving::icosphere(this->Level, this->Radius, center)
        : (this->Shape == CUBE_SPHERE ? evolving::cubeSphere(this->Resolution, this->Radius, center)
                                      : evolving::subdividedBox(this->Resolution,
                                          evolving::Vec3::Constant(this->Radius), center));
      const bool isDouble = this->OutputPointsPrecision == DOUBLE_PRECISION;
      output->ShallowCopy(KernelBridge::WritePolyData(mesh, isDouble ? VTK_DOUBLE : VTK_FLOAT));
    });
}

//------------------------------------------------------------------------------
void vtkIcosphereSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->Shape << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2]
     << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
}
