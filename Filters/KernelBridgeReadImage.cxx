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
Eigen::Affine3d ReadIndexToSpace(vtkImageData* image)
{
  evolving::Vec3 origin;
  evolving::Vec3 spacing;
  int extent[6];
  image->GetOrigin(origin.data());
  image->GetSpacing(spacing.data());
  image->GetExtent(extent);
  const evolving::ImageAxes axes = ReadAxes(image, origin);
  Eigen::Affine3d toSpace = Eigen::Affine3d::Identity();
  for (int axis = 0; axis < 3; ++axis)
  {
    toSpace.linear().col(axis) = axes.vectorToWorld(spacing[axis] * evolving::Vec3::Unit(axis));
  }
  const evolving::Vec3 first(extent[0], extent[2], extent[4]);
  toSpace.translation() = origin + toSpace.linear() * first;
  return toSpace;
}

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
