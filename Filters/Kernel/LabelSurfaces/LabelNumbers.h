// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The labels of an image as numbers in a list.
 */

#ifndef EVOLVING_LABEL_NUMBERS_H
#define EVOLVING_LABEL_NUMBERS_H

#include "Execution.h"
#include "LabelSurfaces/MaterialGrid.h"
#include "Types.h"

#include <array>
#include <functional>
#include <vector>

namespace evolving
{

struct LabelChoice
{
  std::vector<double> labels; ///< empty: all but the background
  double background = 0.0;
};

struct NumberedLabels
{
  std::vector<double> labels;      ///< label 1 first, ascending
  std::vector<Material> materials; ///< of every voxel: the place of its label in the list, from 1
};

/**
 * Labels are whole numbers; all that is no wanted label is background. An image in which most
 * neighbours along x have different labels is one of intensities, unless labels were chosen.
 * @param value of a voxel, x fastest
 * @throws InputError for an image of fewer than two voxels along an axis, values that are no whole
 * numbers, more than MostLabels labels, intensities, or when no chosen label occurs
 * @throws Cancelled
 */
NumberedLabels numberLabels(const std::array<Index, 3>& sizes,
  const std::function<double(GridIndex)>& value, const LabelChoice& choice,
  const Execution& execution = {});

} // namespace evolving

#endif
