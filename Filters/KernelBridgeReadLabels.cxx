// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "KernelBridge.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace KernelBridge
{

namespace
{

/// Of the grid of materials, the labels' own array and the net, which large images have little of.
constexpr int BytesPerVoxel = 8;

//------------------------------------------------------------------------------
void RequireSpacing(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!std::isfinite(spacing[axis]) || !(spacing[axis] > 0.0) ||
      !std::isfinite(image->GetOrigin()[axis]))
    {
      std::ostringstream message;
      message << "The image has the spacing (" << spacing[0] << ", " << spacing[1] << ", "
              << spacing[2]
              << "), expected finite numbers above 0, and an origin; repair the image's header.";
      throw evolving::InputError(message.str());
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
Labels ReadLabels(
  vtkImageData* image, const evolving::LabelChoice& choice, const evolving::Execution& execution)
{
  RequireSpacing(image);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  RequireMemory(scalars->GetNumberOfTuples(), BytesPerVoxel, "extract a part of the image");
  Labels labels;
  int sizes[3];
  image->GetDimensions(sizes);
  labels.image.sizes = { sizes[0], sizes[1], sizes[2] };
  evolving::NumberedLabels numbered = evolving::numberLabels(
    labels.image.sizes, [scalars](evolving::GridIndex i) { return scalars->GetComponent(i, 0); },
    choice, execution);
  labels.values = std::move(numbered.labels);
  labels.image.materials = std::move(numbered.materials);
  labels.image.labelCount = labels.values.size();
  labels.image.toSpace = ReadIndexToSpace(image);
  return labels;
}

} // namespace KernelBridge
