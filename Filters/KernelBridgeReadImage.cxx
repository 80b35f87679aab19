// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"

#include <utility>
#include <vector>

namespace KernelBridge
{

namespace
{

//------------------------------------------------------------------------------
/// The direction matrix turns the image about its origin.
evolving::ImageAxes ReadAxes(vtkImageData* image, const evolving::Vec3& origin)
{
  Eigen::Matrix3d directions;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      directions(row, column) = image->GetDirectionMatrix()->GetElement(row, column);
    }
  }
  return evolving::ImageAxes(directions, origin);
}

} // namespace

//------------------------------------------------------------------------------
evolving::ScalarImage ReadImage(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  evolving::DistanceGrid grid;
  image->GetOrigin(grid.origin.data());
  image->GetSpacing(grid.spacing.data());
  image->GetExtent(grid.extent.data());
  std::vector<float> values(static_cast<std::size_t>(scalars->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<float>(scalars->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return evolving::ScalarImage(grid, std::move(values), ReadAxes(image, grid.origin));
}

} // namespace KernelBridge
