// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * A signed distance as a vtkImageData. Private to the module.
 */

#ifndef DistanceImage_h
#define DistanceImage_h

#include "KernelBridge.h"

#include <vector>

class vtkImageData;

namespace DistanceImage
{

/**
 * The part of the grid with the result's arrays as point arrays: SignedDistance, the active
 * scalars, and as far as they were computed ClosestPoint, ClosestCellId and Gradient; field data
 * SignMethod and SignReason.
 * @param cellOfFace what ClosestCellId calls a face
 */
void Write(const evolving::DistanceGrid& grid, const evolving::Extent& part,
  const evolving::SignedDistanceResult& result, const std::vector<vtkIdType>& cellOfFace,
  vtkImageData* output);

} // namespace DistanceImage

#endif
