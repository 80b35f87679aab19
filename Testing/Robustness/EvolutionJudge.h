// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The judges of surfaces that have been moved or made anew.
 */

#ifndef ROBUSTNESS_EVOLUTION_JUDGE_H
#define ROBUSTNESS_EVOLUTION_JUDGE_H

#include "Subject.h"

class vtkPolyData;
class vtkTable;

namespace robustness
{

/**
 * A state of vtkSurfaceEvolution: field data against the points as they are handed out, the start's
 * topology kept. @throws WrongAnswer
 * @param hasNewElements whether it was remeshed
 */
void judgeState(const Subject& start, bool hasNewElements, vtkPolyData* state);

/// Columns of History against the last state. @throws WrongAnswer
void judgeHistory(vtkTable* history, vtkPolyData* last, const std::vector<std::string>& columns);

/// The finished surface of vtkShrinkWrap. @throws WrongAnswer
void judgeWrap(const Subject& target, bool liesOnTarget, std::size_t warnings, vtkPolyData* result);

/// What is said of Area, Volume, MinAngle, MaxDistance. @throws WrongAnswer
void judgeMeasures(const Surface& surface, const Topology& topology, vtkPolyData* state);

} // namespace robustness

#endif
