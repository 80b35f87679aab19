// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The two flows that the tests of vtkSurfaceEvolution run, and looks at their times and history.
 */

#ifndef FlowSetups_h
#define FlowSetups_h

#include "vtkType.h"

#include <vector>

class vtkAlgorithm;
class vtkPolyData;
class vtkSurfaceEvolution;
class vtkTable;

/// Mean curvature flow of speed 1 in the input's units.
void SetUpCurvatureFlow(
  vtkSurfaceEvolution* filter, vtkPolyData* start, double timeStep, int steps);

/// From a start around a sphere of radius 1 in an image onto it.
void SetUpAttraction(vtkSurfaceEvolution* filter, vtkPolyData* start);

/// The times that a filter publishes on a port.
std::vector<double> TimesOf(vtkAlgorithm* filter, int port = 0);

/// The table on the filter's second output.
vtkTable* HistoryOf(vtkSurfaceEvolution* filter);

double ValueAt(vtkTable* table, vtkIdType row, const char* column);

#endif
