// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkIcosphereSource.h"

#include "KernelBridge.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>

vtkStandardNewMacro(vtkIcosphereSource);

namespace
{

//------------------------------------------------------------------------------
/// Are all points numbers, and those of every edge two, after rounding?
bool IsHeldBy(int pointType, const evolving::SurfaceMesh& mesh)
{
  const std::vector<evolving::Vec3> points =
    pointType == VTK_FLOAT ? evolving::roundedToFloats(mesh.points) : mesh.points;
  const auto isNumber = [](const evolving::Vec3& point) { return point.allFinite(); };
  bool isHeld = std::all_of(points.begin(), points.end(), isNumber);
  for (evolving::Index face = 0; isHeld && face < mesh.faceCount(); ++face)
  {
    const evolving::Index corners = mesh.faceSize(face);
    for (evolving::Index k = 0; k < corners; ++k)
    {
      const auto a = static_cast<std::size_t>(mesh.faceVertex(face, k));
      const auto b = static_cast<std::size_t>(mesh.faceVertex(face, (k + 1) % corners));
      isHeld = isHeld && points[a] != points[b];
    }
  }
  return isHeld;
}

//------------------------------------------------------------------------------
void RequireHeldBy(
  int pointType, const evolving::SurfaceMesh& mesh, double radius, const evolving::Vec3& center)
{
  if (!IsHeldBy(pointType, mesh))
  {
    const bool isFloat = pointType == VTK_FLOAT;
    std::ostringstream message;
    message << "With a Radius of " << radius << " about the Center (" << center.transpose()
            << ") points overflow or fall together in " << (isFloat ? "single" : "double")
            << " precision, expected a surface that it can hold; "
            << (isFloat ? "set OutputPointsPrecision to double, or correct Radius and Center."
                        : "correct Radius and Center.");
    throw evolving::InputError(message.str());
  }
}

} // namespace

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
      const int pointType =
        this->OutputPointsPrecision == DOUBLE_PRECISION ? VTK_DOUBLE : VTK_FLOAT;
      RequireHeldBy(pointType, mesh, this->Radius, center);
      output->ShallowCopy(KernelBridge::WritePolyData(mesh, pointType));
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
