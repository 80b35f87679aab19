// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The judge of vtkTangentialRedistribution: the same cells, points on the input's surface.
 */

#ifndef ROBUSTNESS_REDISTRIBUTION_JUDGE_H
#define ROBUSTNESS_REDISTRIBUTION_JUDGE_H

#include "Subject.h"

class vtkPolyData;

namespace robustness
{

struct RedistributionPromises
{
  bool keepsShape;
  bool keepsBorder;
};

/// @throws WrongAnswer
void judgeRedistribution(
  const Subject& input, const RedistributionPromises& promises, vtkPolyData* output);

} // namespace robustness

#endif
