// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Whether the data of an input are where they belong on a wrap.
 */

#ifndef ROBUSTNESS_DATA_JUDGE_H
#define ROBUSTNESS_DATA_JUDGE_H

#include "Subject.h"

class vtkPolyData;

namespace robustness
{

/// The point array of every subject's data that holds where each point is; 0 for what is no number.
constexpr const char* PlaceArray = "Place";
/// And the cell array with the number of each cell.
constexpr const char* NumberArray = "Number";

/**
 * Point data come from the closest point of the target: its place is as far away as any place of
 * the target at least is, for some points of the result. Every cell has a number that a cell has.
 * @throws WrongAnswer
 */
void judgeWrappedData(const Subject& target, vtkPolyData* result);

} // namespace robustness

#endif
