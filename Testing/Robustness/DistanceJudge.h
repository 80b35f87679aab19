// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The judge of vtkMeshSDF's image: distances against all triangles, signs against the solid.
 */

#ifndef ROBUSTNESS_DISTANCE_JUDGE_H
#define ROBUSTNESS_DISTANCE_JUDGE_H

#include "DistanceReference.h"
#include "Subject.h"

class vtkImageData;
class vtkMeshSDF;

namespace robustness
{

/// @throws WrongAnswer
void judgeDistances(const Subject& subject, vtkMeshSDF* filter, vtkImageData* image);

/// A part of the grid must have the bits of the whole. @throws WrongAnswer
void judgePart(vtkImageData* part, vtkImageData* whole);

} // namespace robustness

#endif
