// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The time steps of an evolution in the pipeline's words. Private to the module.
 */

#ifndef TimeSteps_h
#define TimeSteps_h

#include <cstddef>
#include <vector>

class vtkDataObject;
class vtkInformation;

namespace TimeSteps
{

/// The times of iterations: multiplied, never accumulated.
std::vector<double> Times(const std::vector<int>& iterations, double timeStep);

/// Publishes TIME_STEPS and TIME_RANGE.
void Publish(vtkInformation* outputInformation, const std::vector<double>& times);

/// Takes away what CopyDefaultInformation handed on from the input.
void Remove(vtkInformation* outputInformation);

/**
 * The step an update asks for: the last one without a time, the nearest one otherwise; a time
 * outside the range is clamped.
 */
std::size_t Requested(vtkInformation* outputRequest, const std::vector<double>& times);

/// Says in the data which time they are of.
void Mark(vtkDataObject* output, double time);

} // namespace TimeSteps

#endif
