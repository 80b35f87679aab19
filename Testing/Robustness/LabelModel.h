// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Images of labels, from smooth bodies to noise.
 */

#ifndef ROBUSTNESS_LABEL_MODEL_H
#define ROBUSTNESS_LABEL_MODEL_H

#include "Random.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;

namespace robustness
{

struct LabelModel
{
  vtkSmartPointer<vtkImageData> image;
  std::string story;
  std::vector<double> values; ///< of all voxels, x fastest
  bool hasNaN = false;
  bool hasFraction = false;

  double voxelVolume() const;
  /// A place in numbers of voxels from the first one.
  Vec3 inVoxels(const Vec3& place) const;
  /// In voxels, from a place to the nearest face between a voxel of a label and one of none.
  double distanceToFaces(double label, const Vec3& place) const;
};

/// @param isOdd values may be no labels, and the image a slice
LabelModel drawLabels(Random& random, bool isOdd);

} // namespace robustness

#endif
