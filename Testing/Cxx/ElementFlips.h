// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Polygons that a motion has turned over, counted without the code under test.
 */

#ifndef ElementFlips_h
#define ElementFlips_h

#include "vtkType.h"

class vtkPolyData;

/// Polygons whose normal points against the mean of the angle-weighted normals of their points.
vtkIdType CountFolded(vtkPolyData* surface);

/// Polygons whose normal differs by 90 degrees or more between two states of one surface.
vtkIdType CountTurned(vtkPolyData* before, vtkPolyData* after);

#endif
