// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Area, volume, topology and distances of polygons, measured without the code under test.
 */

#ifndef SurfaceMeasures_h
#define SurfaceMeasures_h

#include <gtest/gtest.h>

class vtkPolyData;

/// Have two surfaces the same polygons, and coordinates that agree to a tolerance?
testing::AssertionResult SameSurface(vtkPolyData* a, vtkPolyData* b, double tolerance);

///@{
/// Of the polygons, cut as fans.
double AreaOf(vtkPolyData* surface);
double VolumeOf(vtkPolyData* surface);
///@}

/// The smallest angle of a corner, in degrees.
double SmallestAngleOf(vtkPolyData* surface);

/// The mean over all polygons of their smallest angle, in degrees.
double MeanAngleOf(vtkPolyData* surface);

/// The standard deviation of the polygons' areas over their mean: 0 for an even surface.
double SpreadOfAreas(vtkPolyData* surface);

/// Directed edges that do not have exactly one polygon each way: 0 for a closed, oriented surface.
int CountBadEdges(vtkPolyData* surface);

/// Points used - edges + polygons: 2 - 2 genus for one closed surface.
int EulerCharacteristic(vtkPolyData* surface);

/// The largest distance of a point of a from the polygons of b.
double LargestDistance(vtkPolyData* a, vtkPolyData* b);

#endif
